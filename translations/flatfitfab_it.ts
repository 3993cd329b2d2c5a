<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>%n pezzo come uno solo</numerusform>
            <numerusform>%n pezzi come uno solo</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (part %2)</source>
        <extracomment>%1 is a section&apos;s name, %2 the number engraved on one of its parts</extracomment>
        <translation>%1 (pezzo %2)</translation>
    </message>
    <message>
        <source>%1 (together since step %2)</source>
        <extracomment>%1 is what is moved, %2 the number of the step that completed it</extracomment>
        <translation>%1 (insieme dal passo %2)</translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>%n altro</numerusform>
            <numerusform>altri %n</numerusform>
        </translation>
    </message>
    <message>
        <source>up</source>
        <comment>direction of a way</comment>
        <translation>verso l’alto</translation>
    </message>
    <message>
        <source>down</source>
        <comment>direction of a way</comment>
        <translation>verso il basso</translation>
    </message>
    <message>
        <source>to the right</source>
        <comment>direction of a way</comment>
        <translation>verso destra</translation>
    </message>
    <message>
        <source>to the left</source>
        <comment>direction of a way</comment>
        <translation>verso sinistra</translation>
    </message>
    <message>
        <source>to the front</source>
        <comment>direction of a way</comment>
        <translation>in avanti</translation>
    </message>
    <message>
        <source>to the back</source>
        <comment>direction of a way</comment>
        <translation>all’indietro</translation>
    </message>
    <message>
        <source>along the arrow</source>
        <comment>direction of a way</comment>
        <translation>lungo la freccia</translation>
    </message>
    <message>
        <source>There is no section yet, so there are no steps.</source>
        <translation>Non c’è ancora nessuna sezione, quindi nemmeno passi.</translation>
    </message>
    <message>
        <source>Nothing is cut from this model, so there are no steps.</source>
        <translation>Da questo modello non si taglia nulla, quindi non ci sono passi.</translation>
    </message>
    <message>
        <source>No steps to show: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Nessun passo da mostrare: %1.</translation>
    </message>
    <message>
        <source>No steps to show: the order of assembly was not found in time.</source>
        <translation>Nessun passo da mostrare: l’ordine di montaggio non è stato trovato in tempo.</translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>Nessun passo da mostrare: il modello non si può montare, perché %n sezione è bloccata.</numerusform>
            <numerusform>Nessun passo da mostrare: il modello non si può montare, perché %n sezioni si bloccano a vicenda.</numerusform>
        </translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since parts of %1 block each other.</source>
        <translation>Nessun passo da mostrare: il modello non si può montare, perché i pezzi di %1 si bloccano a vicenda.</translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since %1 block each other.</source>
        <translation>Nessun passo da mostrare: il modello non si può montare, perché %1 si bloccano a vicenda.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Passo %1 di %2</translation>
    </message>
    <message>
        <source>start with %1</source>
        <translation>comincia con %1</translation>
    </message>
    <message>
        <source>start a group of its own with %1</source>
        <translation>comincia un gruppo a parte con %1</translation>
    </message>
    <message>
        <source>put %1 in place</source>
        <translation>metti %1 in posizione</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, finally %2</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>infila %1 aggirando l’angolo, alla fine %2</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, then slide it %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>infila %1 aggirando l’angolo, poi fai scorrere %2 in %3</translation>
    </message>
    <message>
        <source>move %1 %2 into place</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>sposta %1 %2 fino in posizione</translation>
    </message>
    <message>
        <source>slide %1 %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>fai scorrere %1 %2 in %3</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>Holds %1 more here before %2 cracks %3.</source>
        <extracomment>%1 is a mass, %2 a section, %3 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Qui regge ancora %1 prima che %2 si crepi %3.</translation>
    </message>
    <message>
        <source>Holds %1 here before %2 cracks %3.</source>
        <translation>Qui regge %1 prima che %2 si crepi %3.</translation>
    </message>
    <message>
        <source>Holds %1 more here before it falls over.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Qui regge ancora %1 prima di ribaltarsi.</translation>
    </message>
    <message>
        <source>Holds %1 here before it falls over.</source>
        <translation>Qui regge %1 prima di ribaltarsi.</translation>
    </message>
    <message>
        <source>Holds %1 more here before a joint is pulled open.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Qui regge ancora %1 prima che un incastro si sfili.</translation>
    </message>
    <message>
        <source>Holds %1 here before a joint is pulled open.</source>
        <translation>Qui regge %1 prima che un incastro si sfili.</translation>
    </message>
    <message>
        <source>Holds more than %1 here.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Qui regge più di %1.</translation>
    </message>
    <message>
        <source>How much it holds here could not be worked out.</source>
        <translation>Non si è potuto calcolare quanto regge qui.</translation>
    </message>
    <message>
        <source>Widen the base</source>
        <translation>Allarga la base</translation>
    </message>
    <message>
        <source>Add a foot</source>
        <translation>Aggiungi un piede</translation>
    </message>
    <message>
        <source>Connected. Only one section so far.</source>
        <translation>Collegato. Per ora c’è una sola sezione.</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 incastro</translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>%n incastro</numerusform>
            <numerusform>%n incastri</numerusform>
        </translation>
    </message>
    <message>
        <source>Connected. Both sections, by %1.</source>
        <translation>Collegato. Entrambe le sezioni, con %1.</translation>
    </message>
    <message>
        <source>Connected. All %1 sections, by %2.</source>
        <translation>Collegato. Tutte le %1 sezioni, con %2.</translation>
    </message>
    <message>
        <source>Would be connected %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Sarebbe collegato %1.</translation>
    </message>
    <message>
        <source>%1 is not joined to the rest.</source>
        <translation>%1 non è collegata al resto.</translation>
    </message>
    <message>
        <source>%1 are not joined to the rest.</source>
        <translation>%1 non sono collegate al resto.</translation>
    </message>
    <message>
        <source>%1 meets %2, but nothing holds them together.</source>
        <translation>%1 incontra %2, ma nulla le tiene insieme.</translation>
    </message>
    <message>
        <source>%1 meet %2, but nothing holds them together.</source>
        <translation>%1 incontrano %2, ma nulla le tiene insieme.</translation>
    </message>
    <message>
        <source>Nothing touches %1. It is %2 away from %3.</source>
        <translation>Nulla tocca %1. Dista %2 da %3.</translation>
    </message>
    <message>
        <source>Nothing else touches %1. They are %2 away from %3.</source>
        <translation>Nient’altro tocca %1. Distano %2 da %3.</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Elimina tutte</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Collegato</translation>
    </message>
    <message>
        <source>Would be connected</source>
        <translation>Sarebbe collegato</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Non collegato</translation>
    </message>
    <message>
        <source>Draw a section that crosses both, or move one of them to the other.</source>
        <translation>Disegna una sezione che le attraversi entrambe o avvicina una delle due all’altra.</translation>
    </message>
    <message>
        <source>Not connected yet</source>
        <translation>Non ancora collegato</translation>
    </message>
    <message>
        <source>if it held together</source>
        <translation>se restasse insieme</translation>
    </message>
    <message>
        <source>if nothing fell apart</source>
        <translation>se nulla si disfacesse</translation>
    </message>
    <message>
        <source>if the kerf closed no slit</source>
        <translation>se il solco di taglio non chiudesse nessuna fessura</translation>
    </message>
    <message>
        <source>if no slit were too tight</source>
        <translation>se nessuna fessura fosse troppo stretta</translation>
    </message>
    <message>
        <source>if no slit were too wide</source>
        <translation>se nessuna fessura fosse troppo larga</translation>
    </message>
    <message>
        <source>if it did not fold</source>
        <translation>se non si ripiegasse</translation>
    </message>
    <message>
        <source>if it did not slide away</source>
        <translation>se non scivolasse via</translation>
    </message>
    <message>
        <source>if nothing came loose</source>
        <translation>se nulla si staccasse</translation>
    </message>
    <message>
        <source>if no joint were pulled open</source>
        <translation>se nessun incastro si sfilasse</translation>
    </message>
    <message>
        <source>if nothing pushed it</source>
        <translation>se nulla lo spingesse</translation>
    </message>
    <message>
        <source>End one at the other</source>
        <translation>Termina una sull’altra</translation>
    </message>
    <message>
        <source>End %1 at %2</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>Termina %1 su %2</translation>
    </message>
    <message>
        <source>Their joint is set to “None”.</source>
        <translation>Il loro incastro è impostato su “Nessuno”.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: the negative clearance leaves it no width. Make the clearance larger.</source>
        <translation>Nessuna fessura permette di infilarle: il gioco negativo non le lascia larghezza. Aumenta il gioco.</translation>
    </message>
    <message>
        <source>No slits let them slide together: in one place they could only slide one way, in another only the other way. Shorten one of them.</source>
        <translation>Nessuna fessura permette di infilarle: in un punto potrebbero scorrere solo in un verso, in un altro solo nell’altro. Accorcia una delle due.</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin. Make the holes smaller, or let one of them end inside the other.</source>
        <translation>Nulla le terrebbe: ci sono fori dove inizierebbero le fessure. Rimpicciolisci i fori o fai terminare una dentro l’altra.</translation>
    </message>
    <message>
        <source>No slit lets them slide together: neither of them reaches the edge. Open a hole to the outside, or let one of them pass through.</source>
        <translation>Nessuna fessura permette di infilarle: nessuna delle due arriva al bordo. Apri un foro verso l’esterno o fai passare una attraverso l’altra.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap, %3 long. %4</source>
        <translation>%1 e %2 si sovrappongono per %3. %4</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>meno di %1</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, outside their slits.</source>
        <translation>%1 e %2 si sovrappongono di %3, fuori dalle fessure.</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, but are not joined.</source>
        <translation>%1 e %2 si sovrappongono di %3, ma non sono collegate.</translation>
    </message>
    <message>
        <source>%1 and %2 almost lie in one plane: they meet at %3, and below %4 no slit can hold them.</source>
        <translation>%1 e %2 sono quasi sullo stesso piano: si incontrano a %3, e sotto %4 nessuna fessura può tenerle.</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3; slits get wide below %4.</source>
        <translation>%1 e %2 si incontrano a %3; sotto %4 le fessure diventano larghe.</translation>
    </message>
    <message>
        <source>Move one of them aside, or let it end before the other.</source>
        <translation>Sposta una delle due di lato o falla terminare prima dell’altra.</translation>
    </message>
    <message>
        <source>Sections overlap</source>
        <translation>Sezioni sovrapposte</translation>
    </message>
    <message>
        <source>Angle too flat</source>
        <translation>Angolo troppo piatto</translation>
    </message>
    <message>
        <source>Turn one of them to a steeper angle.</source>
        <translation>Ruota una delle due a un angolo più ripido.</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>Collega</translation>
    </message>
    <message>
        <source>Join it with %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Collega a %1</translation>
    </message>
    <message>
        <source>Join them with %1</source>
        <translation>Collega tutte a %1</translation>
    </message>
    <message>
        <source>Move it to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sposta verso %1</translation>
    </message>
    <message>
        <source>Move them to %1</source>
        <translation>Sposta tutte verso %1</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Accorcia %1</translation>
    </message>
    <message>
        <source>Join with tabs</source>
        <translation>Collega con linguette</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit runs along its edge and has material on one side only.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 non tiene %2: la sua fessura corre lungo il bordo e ha materiale su un solo lato.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slits cut it right through there.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 non tiene %2: lì le fessure la tagliano da parte a parte.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit is less than %3 deep.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 non tiene %2: la sua fessura è profonda meno di %3.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit leaves no material on either side.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 non tiene %2: la sua fessura non lascia materiale su nessun lato.</translation>
    </message>
    <message>
        <source>%1 does not hold %2: other slits take away what would be in its slit.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 non tiene %2: altre fessure portano via ciò che starebbe nella sua fessura.</translation>
    </message>
    <message>
        <source>Move the slit in from the edge.</source>
        <translation>Allontana la fessura dal bordo.</translation>
    </message>
    <message>
        <source>Let one of the sections that cross there end before the others, or move it aside.</source>
        <translation>Fai terminare una delle sezioni che si incrociano lì prima delle altre, o spostala di lato.</translation>
    </message>
    <message>
        <source>Slit holds nothing</source>
        <translation>Fessura che non tiene nulla</translation>
    </message>
    <message>
        <source>Slits cut %1 into %2 parts</source>
        <extracomment>%1 is the name of a section, %2 a number from 2 on</extracomment>
        <translation>Le fessure tagliano %1 in %2 pezzi</translation>
    </message>
    <message>
        <source>%1 comes out in %2 parts</source>
        <translation>%1 è in %2 pezzi</translation>
    </message>
    <message>
        <source>%1; nothing holds one of them, %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; nulla ne tiene uno, %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds them, the largest being %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1; nulla li tiene, il più grande è %2.</translation>
    </message>
    <message>
        <source>%1; nothing holds %2 of them, the largest being %3.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 4 parts&quot;, %2 a number from 2 on, %3 a size</extracomment>
        <translation>%1; nulla ne tiene %2, il più grande è %3.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, which hangs together.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>Le fessure tagliano %1 in più pezzi. Ciò che è tagliato via resta unito, ma nulla lo tiene.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, together with %2.</source>
        <extracomment>%1 and %2 name sections</extracomment>
        <translation>Le fessure tagliano %1 in più pezzi. Nulla tiene ciò che è tagliato via, insieme a %2.</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds its part of %2 with %3.</source>
        <extracomment>%1 is the name of a section, %2 a size, %3 names of sections</extracomment>
        <translation>Le fessure tagliano %1 in più pezzi. Nulla tiene il suo pezzo da %2 con %3.</translation>
    </message>
    <message>
        <source>Flip slits</source>
        <translation>Inverti le fessure</translation>
    </message>
    <message>
        <source>Loose parts</source>
        <translation>Pezzi sciolti</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Allontana %1 dal bordo</translation>
    </message>
    <message>
        <source>Move %1 away</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Allontana %1</translation>
    </message>
    <message>
        <source>Make the slit shallower</source>
        <translation>Accorcia la fessura</translation>
    </message>
    <message>
        <source>Slit %1 is closed by the kerf of %2. Give the stock&apos;s slits more clearance, or less kerf.</source>
        <translation>La fessura %1 è chiusa dal solco di taglio di %2. Dai più gioco alle fessure del materiale o riduci il solco.</translation>
    </message>
    <message>
        <source>Slit %1 is narrower than the %2 tool. Give the stock&apos;s slits more clearance, or choose a thinner tool.</source>
        <translation>La fessura %1 è più stretta dell’utensile da %2. Dai più gioco alle fessure del materiale o scegli un utensile più sottile.</translation>
    </message>
    <message>
        <source>Between their bumps slits are %1 narrower than what goes into them. That is too tight for any material: make the bumps smaller.</source>
        <translation>Tra i rilievi le fessure sono %1 più strette di ciò che ci entra. È troppo stretto per qualsiasi materiale: riduci i rilievi.</translation>
    </message>
    <message>
        <source>Slits are %1 narrower than what goes into them. That is too tight for any material.</source>
        <translation>Le fessure sono %1 più strette di ciò che ci entra. È troppo stretto per qualsiasi materiale.</translation>
    </message>
    <message>
        <source>Slits are %1 wider than what goes into them, so it sits loosely.</source>
        <translation>Le fessure sono %1 più larghe di ciò che ci entra, che quindi balla.</translation>
    </message>
    <message>
        <source>Set the clearance</source>
        <translation>Imposta il gioco</translation>
    </message>
    <message>
        <source>Slits too tight</source>
        <translation>Fessure troppo strette</translation>
    </message>
    <message>
        <source>Slits too wide</source>
        <translation>Fessure troppo larghe</translation>
    </message>
    <message>
        <source>Slit narrower than the tool</source>
        <translation>Fessura più stretta dell’utensile</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Riprova</translation>
    </message>
    <message>
        <source>Show the copy for a report</source>
        <translation>Mostra la copia per una segnalazione</translation>
    </message>
    <message>
        <source>Not worked out</source>
        <translation>Non calcolato</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Falls over forwards.&quot;</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Can be assembled. Only one part so far.</source>
        <translation>Montabile. Per ora c’è un solo pezzo.</translation>
    </message>
    <message>
        <source>Can be assembled. But nothing holds one of the parts.</source>
        <translation>Montabile. Ma nulla tiene uno dei pezzi.</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>Montabile. Ma nulla tiene %n dei pezzi.</numerusform>
            <numerusform>Montabile. Ma nulla tiene %n dei pezzi.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>Montabile. %n passo.</numerusform>
            <numerusform>Montabile. %n passi.</numerusform>
        </translation>
    </message>
    <message>
        <source>Could be assembled %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>Si potrebbe montare %1.</translation>
    </message>
    <message>
        <source>Cannot be assembled yet. It could be if two sections did not overlap.</source>
        <translation>Non ancora montabile. Lo sarebbe se due sezioni non si sovrapponessero.</translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>Non ancora montabile. Lo sarebbe se %n coppia di sezioni non si sovrapponesse.</numerusform>
            <numerusform>Non ancora montabile. Lo sarebbe se %n coppie di sezioni non si sovrapponessero.</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Mostra i passi</translation>
    </message>
    <message>
        <source>Sections block each other. %1 meet in %2 that slide in %3 different directions.</source>
        <translation>Sezioni che si bloccano a vicenda. %1 si incontrano in %2 che scorrono in %3 direzioni diverse.</translation>
    </message>
    <message>
        <source>Sections block each other. %1 comes only %2 out of its slit before it hits %3.</source>
        <translation>Sezioni che si bloccano a vicenda. %1 esce solo di %2 dalla sua fessura prima di urtare %3.</translation>
    </message>
    <message>
        <source>Sections block each other. None of %1 can be removed in a straight line.</source>
        <translation>Sezioni che si bloccano a vicenda. Nessuna tra %1 si può sfilare in linea retta.</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Rendi montabile</translation>
    </message>
    <message>
        <source>1 joint flipped.</source>
        <translation>1 incastro invertito.</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>%n incastro invertito.</numerusform>
            <numerusform>%n incastri invertiti.</numerusform>
        </translation>
    </message>
    <message>
        <source>Order not found: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>Ordine non trovato: %1.</translation>
    </message>
    <message>
        <source>Order not found. The search took too long; that says nothing about the model.</source>
        <translation>Ordine non trovato. La ricerca è durata troppo: questo non dice nulla sul modello.</translation>
    </message>
    <message>
        <source>Can be assembled</source>
        <translation>Montabile</translation>
    </message>
    <message>
        <source>Could be assembled</source>
        <translation>Si potrebbe montare</translation>
    </message>
    <message>
        <source>Cannot be assembled yet</source>
        <translation>Non ancora montabile</translation>
    </message>
    <message>
        <source>Cannot be assembled</source>
        <translation>Non montabile</translation>
    </message>
    <message>
        <source>Shorten one of them, or turn it so that it slides in the same direction as the others.</source>
        <translation>Accorcia una di loro o ruotala in modo che scorra nella stessa direzione delle altre.</translation>
    </message>
    <message>
        <source>Order not found</source>
        <translation>Ordine non trovato</translation>
    </message>
    <message>
        <source>Pulled open. The joint of %1 and %2 is pulled apart by %3 N.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Incastro che si sfila. L’incastro di %1 e %2 è tirato con %3 N.</translation>
    </message>
    <message>
        <source>Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; the others hold without it.</source>
        <translation>Non porta nulla. L’incastro di %1 e %2 è tirato con %3 N; gli altri reggono anche senza.</translation>
    </message>
    <message>
        <source>Held by friction. The joint of %1 and %2 is pulled with %3 N, which only a tight fit holds.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>Tenuto dall’attrito. L’incastro di %1 e %2 è tirato con %3 N, che solo un incastro stretto può reggere.</translation>
    </message>
    <message>
        <source>Pulled open</source>
        <translation>Incastro che si sfila</translation>
    </message>
    <message>
        <source>Carries nothing</source>
        <translation>Non porta nulla</translation>
    </message>
    <message>
        <source>Flip its slits</source>
        <translation>Inverti le sue fessure</translation>
    </message>
    <message>
        <source>Glue it.</source>
        <translation>Incollalo.</translation>
    </message>
    <message>
        <source>Held by friction</source>
        <translation>Tenuto dall’attrito</translation>
    </message>
    <message>
        <source>Pushed over. Without its pushes it would stand.</source>
        <translation>Ribaltato dalla spinta. Senza spinte starebbe in piedi.</translation>
    </message>
    <message>
        <source>Pushed over</source>
        <translation>Ribaltato dalla spinta</translation>
    </message>
    <message>
        <source>Give it a broader base or more weight, or push less, or lower down.</source>
        <translation>Dagli una base più larga o più peso, oppure spingi meno o più in basso.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: put them together in the order of the steps.</source>
        <translation>%1 sono collegate ad anello: montale nell’ordine dei passi.</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: whichever goes in last has to slide onto two others at once.</source>
        <translation>%1 sono collegate ad anello: quella che entra per ultima deve infilarsi su altre due insieme.</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>Ci sono sezioni collegate in %n anello: montale nell’ordine dei passi.</numerusform>
            <numerusform>Ci sono sezioni collegate in %n anelli: montale nell’ordine dei passi.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>Ci sono sezioni collegate in %n anello: quella che entra per ultima deve infilarsi su altre due insieme.</numerusform>
            <numerusform>Ci sono sezioni collegate in %n anelli: in ciascuno, quella che entra per ultima deve infilarsi su altre due insieme.</numerusform>
        </translation>
    </message>
    <message>
        <source>Joined in a ring</source>
        <translation>Collegate ad anello</translation>
    </message>
    <message>
        <source>Support it with a foot</source>
        <translation>Sostieni con un piede</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 lastra</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n lastra</numerusform>
            <numerusform>%n lastre</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1, %2 % used.</source>
        <translation>Entra nella lastra. %1, %2 % utilizzato.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2, %3 % used.</source>
        <translation>Entra nella lastra. %1 da %2, %3 % utilizzato.</translation>
    </message>
    <message>
        <source>%1 parts of %2 fit no sheet of %3 with a margin of %4, however they are turned.</source>
        <translation>%1 pezzi di %2 non entrano in nessuna lastra da %3 con un margine di %4, comunque siano ruotati.</translation>
    </message>
    <message>
        <source>%1 measures %2 and fits no sheet of %3 with a margin of %4, however it is turned.</source>
        <translation>%1 misura %2 e non entra in nessuna lastra da %3 con un margine di %4, comunque sia ruotata.</translation>
    </message>
    <message>
        <source>Choose a sheet</source>
        <translation>Scegli una lastra</translation>
    </message>
    <message>
        <source>Fits the sheet</source>
        <translation>Entra nella lastra</translation>
    </message>
    <message>
        <source>Too large for the sheet</source>
        <translation>Troppo grande per la lastra</translation>
    </message>
    <message>
        <source>Stretch them to the ground</source>
        <translation>Allunga tutte fino al suolo</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Allunga %1 fino al suolo</translation>
    </message>
    <message>
        <source>Drop it to the ground</source>
        <translation>Appoggia al suolo</translation>
    </message>
    <message>
        <source>Raise it to the ground</source>
        <translation>Alza fino al suolo</translation>
    </message>
    <message>
        <source>Stands, but rocks by %1. Tips only past %2. Margin %3.</source>
        <translation>Sta in piedi, ma dondola di %1. Si ribalta solo oltre %2. Margine %3.</translation>
    </message>
    <message>
        <source>Stands. Tips only past %1. Margin %2.</source>
        <translation>Sta in piedi. Si ribalta solo oltre %1. Margine %2.</translation>
    </message>
    <message>
        <source>Stands, %1 aslant. Tips only past %2. Margin %3.</source>
        <translation>Sta in piedi, storto di %1. Si ribalta solo oltre %2. Margine %3.</translation>
    </message>
    <message>
        <source>The lowest point of %1 is %2 above the ground.</source>
        <translation>Il punto più basso di %1 è %2 sopra il suolo.</translation>
    </message>
    <message>
        <source>The lowest points of %1 are up to %2 above the ground.</source>
        <translation>I punti più bassi di %1 sono fino a %2 sopra il suolo.</translation>
    </message>
    <message>
        <source>Leans %1 forwards</source>
        <translation>Si inclina di %1 in avanti</translation>
    </message>
    <message>
        <source>Leans %1 backwards</source>
        <translation>Si inclina di %1 all’indietro</translation>
    </message>
    <message>
        <source>Leans %1 to its left</source>
        <translation>Si inclina di %1 a sinistra</translation>
    </message>
    <message>
        <source>Leans %1 to its right</source>
        <translation>Si inclina di %1 a destra</translation>
    </message>
    <message>
        <source>Rocks by %1: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>Dondola di %1: i suoi punti più bassi non sono tutti sul suolo. Si ribalta solo oltre %2.</translation>
    </message>
    <message>
        <source>%1 before it stands: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>%1 prima di stare in piedi: i suoi punti più bassi non sono tutti sul suolo. Si ribalta solo oltre %2.</translation>
    </message>
    <message>
        <source>Would stand %1. It would tip only past %2. Margin %3.</source>
        <extracomment>%1 is such as &quot;if it did not fold&quot;; %2 an angle, %3 a length</extracomment>
        <translation>Starebbe in piedi %1. Si ribalterebbe solo oltre %2. Margine %3.</translation>
    </message>
    <message>
        <source>Falls at a touch: tilted by %1 it tips over. Margin %2.</source>
        <translation>Cade al minimo tocco: inclinato di %1 si ribalta. Margine %2.</translation>
    </message>
    <message>
        <source>Barely stands: tilted by %1 it tips over. Margin %2.</source>
        <translation>Sta in piedi a malapena: inclinato di %1 si ribalta. Margine %2.</translation>
    </message>
    <message>
        <source>Rocks</source>
        <translation>Dondola</translation>
    </message>
    <message>
        <source>Leans</source>
        <translation>Sta storto</translation>
    </message>
    <message>
        <source>Falls at a touch</source>
        <translation>Cade al minimo tocco</translation>
    </message>
    <message>
        <source>Tips easily</source>
        <translation>Poco stabile</translation>
    </message>
    <message>
        <source>Falls over forwards. The centre of mass lies %1 in front of the feet.</source>
        <translation>Si ribalta in avanti. Il baricentro è %1 davanti ai piedi.</translation>
    </message>
    <message>
        <source>Falls over backwards. The centre of mass lies %1 behind the feet.</source>
        <translation>Si ribalta all’indietro. Il baricentro è %1 dietro i piedi.</translation>
    </message>
    <message>
        <source>Falls over to its left. The centre of mass lies %1 outside its feet.</source>
        <translation>Si ribalta sul fianco sinistro. Il baricentro è %1 fuori dai piedi.</translation>
    </message>
    <message>
        <source>Falls over to its right. The centre of mass lies %1 outside its feet.</source>
        <translation>Si ribalta sul fianco destro. Il baricentro è %1 fuori dai piedi.</translation>
    </message>
    <message>
        <source>Falls over. Its feet are all on one line, so nothing holds it upright.</source>
        <translation>Si ribalta. I piedi sono tutti su una linea, quindi nulla lo tiene dritto.</translation>
    </message>
    <message>
        <source>Not on the ground. Their lowest point is %1 above it.</source>
        <translation>Non poggia sul suolo. Il loro punto più basso è %1 più in alto.</translation>
    </message>
    <message>
        <source>Not on the ground. Its lowest point is %1 above it.</source>
        <translation>Non poggia sul suolo. Il punto più basso è %1 più in alto.</translation>
    </message>
    <message>
        <source>Give it another foot, or move weight over its feet.</source>
        <translation>Aggiungi un altro piede o sposta del peso sopra i piedi.</translation>
    </message>
    <message>
        <source>Join it to what stands, or move it to the ground.</source>
        <translation>Collegalo a ciò che sta in piedi o spostalo sul suolo.</translation>
    </message>
    <message>
        <source>Does not stand yet</source>
        <translation>Non sta ancora in piedi</translation>
    </message>
    <message>
        <source>Not on the ground yet</source>
        <translation>Non poggia ancora sul suolo</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Sta in piedi</translation>
    </message>
    <message>
        <source>Would stand</source>
        <translation>Starebbe in piedi</translation>
    </message>
    <message>
        <source>Make all its feet end at the same height.</source>
        <translation>Fai terminare tutti i piedi alla stessa altezza.</translation>
    </message>
    <message>
        <source>Falls over</source>
        <translation>Si ribalta</translation>
    </message>
    <message>
        <source>Not on the ground</source>
        <translation>Non poggia sul suolo</translation>
    </message>
    <message>
        <source>%1 times as much</source>
        <extracomment>%1 is a number such as 2.5, of all weights and pushes</extracomment>
        <translation>%1 volte tanto</translation>
    </message>
    <message>
        <source>its load</source>
        <translation>il suo carico</translation>
    </message>
    <message>
        <source>Strong enough</source>
        <translation>Abbastanza robusto</translation>
    </message>
    <message>
        <source>Holds %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Regge %1</translation>
    </message>
    <message>
        <source>Would be strong enough</source>
        <translation>Sarebbe abbastanza robusto</translation>
    </message>
    <message>
        <source>Would hold %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Reggerebbe %1</translation>
    </message>
    <message>
        <source>May crack</source>
        <translation>Può creparsi</translation>
    </message>
    <message>
        <source>Barely strong enough</source>
        <translation>Robusto appena quanto basta</translation>
    </message>
    <message>
        <source>May crack under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Può creparsi con %1</translation>
    </message>
    <message>
        <source>Barely holds %1</source>
        <translation>Regge appena %1</translation>
    </message>
    <message>
        <source>Will break</source>
        <translation>Si romperà</translation>
    </message>
    <message>
        <source>Too weak</source>
        <translation>Troppo debole</translation>
    </message>
    <message>
        <source>Breaks under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>Si rompe con %1</translation>
    </message>
    <message>
        <source>Too weak for %1</source>
        <translation>Troppo debole per %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>a verdict such as &quot;Holds 350 g&quot; and sentences about it</extracomment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 breaks %2 from %3.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 si rompe %2 già con %3.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3;</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 può creparsi %2 già con %3;</translation>
    </message>
    <message>
        <source>its neck breaks at %1.</source>
        <extracomment>the section that was just named; %1 is a mass</extracomment>
        <translation>la sua strozzatura si rompe con %1.</translation>
    </message>
    <message>
        <source>the neck of %1 breaks at %2.</source>
        <extracomment>%1 is a section, %2 a mass</extracomment>
        <translation>la strozzatura di %1 si rompe con %2.</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3.</source>
        <translation>%1 può creparsi %2 già con %3.</translation>
    </message>
    <message>
        <source>With %1 a joint is pulled open.</source>
        <translation>Con %1 un incastro si sfila.</translation>
    </message>
    <message>
        <source>With %1 it no longer stands.</source>
        <translation>Con %1 non sta più in piedi.</translation>
    </message>
    <message>
        <source>It would hold far more.</source>
        <translation>Reggerebbe molto di più.</translation>
    </message>
    <message>
        <source>How much it would hold could not be worked out.</source>
        <translation>Non si è potuto calcolare quanto reggerebbe.</translation>
    </message>
    <message>
        <source>Nothing puts a strain on it.</source>
        <translation>Nulla lo sollecita.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: less than 1 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>Il punto più debole è %1, %2: meno dell’1 % della sua resistenza.</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: %3 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a number of percent</extracomment>
        <translation>Il punto più debole è %1, %2: %3 % della sua resistenza.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Si flette di %1.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is such as &quot;Would hold 350 g&quot;, %2 such as &quot;if it held together&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The neck of %1 is strained to %2 % of its strength.</source>
        <extracomment>%1 is a section, %2 a number of percent</extracomment>
        <translation>La strozzatura di %1 è sollecitata al %2 % della sua resistenza.</translation>
    </message>
    <message>
        <source>That leaves less than the safety factor of %1.</source>
        <extracomment>%1 is a number such as 2</extracomment>
        <translation>Resta meno del fattore di sicurezza %1.</translation>
    </message>
    <message>
        <source>Strength unknown. No strength is set for the stock of %1.</source>
        <translation>Resistenza sconosciuta. Per il materiale di %1 non è impostata nessuna resistenza.</translation>
    </message>
    <message>
        <source>Strength unknown. The forces between the sections could not be worked out.</source>
        <translation>Resistenza sconosciuta. Non si sono potute calcolare le forze tra le sezioni.</translation>
    </message>
    <message>
        <source>Strength unknown. The stress in %1 could not be worked out.</source>
        <translation>Resistenza sconosciuta. Non si è potuta calcolare la tensione in %1.</translation>
    </message>
    <message>
        <source>Slides away. Its feet do not hold it against what pushes it: push less, or give it more weight.</source>
        <translation>Scivola via. I piedi non lo trattengono contro ciò che lo spinge: spingi meno o dagli più peso.</translation>
    </message>
    <message>
        <source>Comes loose. Nothing keeps %1 in place: glue the joints, or add one more.</source>
        <translation>Si stacca. Nulla tiene %1 al suo posto: incolla gli incastri o aggiungine uno.</translation>
    </message>
    <message>
        <source>Folds. Fingers turn like hinges, and nothing else keeps %1 from turning: glue them, or join them to one more section.</source>
        <translation>Si ripiega. I denti girano come cerniere e nient’altro impedisce a %1 di girare: incollali o collegala a un’altra sezione.</translation>
    </message>
    <message>
        <source>Off the material. A weight on %1 misses its material; the nearest place takes it.</source>
        <translation>Fuori dal materiale. Un peso su %1 cade dove non c’è materiale: lo porta il punto più vicino.</translation>
    </message>
    <message>
        <source>Use thicker stock, make it wider there, or put less on it.</source>
        <translation>Usa un materiale più spesso, allarga in quel punto o mettici sopra meno peso.</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Resistenza sconosciuta</translation>
    </message>
    <message>
        <source>Comes loose</source>
        <translation>Si stacca</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>Si ripiega</translation>
    </message>
    <message>
        <source>Off the material</source>
        <translation>Fuori dal materiale</translation>
    </message>
    <message>
        <source>Use stock %1 thick</source>
        <extracomment>%1 is the thickness, the least one that is sold and that holds</extracomment>
        <translation>Usa un materiale spesso %1</translation>
    </message>
    <message>
        <source>Use thicker stock</source>
        <translation>Usa un materiale più spesso</translation>
    </message>
    <message>
        <source>Enter its strength</source>
        <translation>Inserisci la resistenza</translation>
    </message>
    <message>
        <source>Falls apart. %1 is held together by less than can be cut.</source>
        <translation>Si disfa. %1 è tenuta insieme da meno di quanto si possa tagliare.</translation>
    </message>
    <message>
        <source>Too little material. %1 is only %2 wide at one place.</source>
        <translation>Troppo poco materiale. In un punto %1 è larga solo %2.</translation>
    </message>
    <message>
        <source>Falls apart</source>
        <translation>Si disfa</translation>
    </message>
    <message>
        <source>Make it wider there, or move apart what touches it.</source>
        <translation>Allarga in quel punto o allontana ciò che si tocca.</translation>
    </message>
    <message>
        <source>Too little material</source>
        <translation>Troppo poco materiale</translation>
    </message>
    <message>
        <source>Make it wider there.</source>
        <translation>Allarga in quel punto.</translation>
    </message>
    <message>
        <source>%1: its slits for %2 run into each other.</source>
        <translation>%1: le sue fessure per %2 finiscono una nell’altra.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slits for %2.</source>
        <translation>%1: tra le sue fessure per %2 non resta nulla.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and a hole.</source>
        <translation>%1: tra la sua fessura per %2 e un foro non resta nulla.</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and its edge.</source>
        <translation>%1: tra la sua fessura per %2 e il bordo non resta nulla.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slits for %3.</source>
        <translation>%1: tra le sue fessure per %3 restano solo %2 di materiale.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and a hole.</source>
        <translation>%1: tra la sua fessura per %3 e un foro restano solo %2 di materiale.</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and its edge.</source>
        <translation>%1: tra la sua fessura per %3 e il bordo restano solo %2 di materiale.</translation>
    </message>
    <message>
        <source>Rather thin</source>
        <translation>Piuttosto sottile</translation>
    </message>
    <message>
        <source>Make the section wider there, or move the slit.</source>
        <translation>Allarga la sezione in quel punto o sposta la fessura.</translation>
    </message>
    <message>
        <source>Slits run into each other</source>
        <translation>Fessure una nell’altra</translation>
    </message>
    <message>
        <source>Mass %1. The centre of mass lies %2 above the ground.</source>
        <translation>Massa %1. Il baricentro è %2 sopra il suolo.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>%1 and %2 only touch: they overlap by less than %3.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 e %2 si toccano soltanto: si sovrappongono per meno di %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n coppia di sezioni si tocca soltanto: si sovrappone per meno di %1.</numerusform>
            <numerusform>%n coppie di sezioni si toccano soltanto: si sovrappongono per meno di %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only touch</source>
        <translation>Si toccano soltanto</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ruota %1 a 90°</translation>
    </message>
    <message>
        <source>Slits cut a chip under 1 mm² off %1. It is waste and gets no number.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Le fessure staccano da %1 una scheggia sotto 1 mm². È uno scarto e non riceve numero.</translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>Le fessure staccano da %1 %n scheggia sotto 1 mm². È uno scarto e non riceve numero.</numerusform>
            <numerusform>Le fessure staccano da %1 %n schegge sotto 1 mm². Sono scarti e non ricevono numero.</numerusform>
        </translation>
    </message>
    <message>
        <source>Waste</source>
        <translation>Scarto</translation>
    </message>
    <message>
        <source>The slits of %1 divide it into %2, which other sections hold together.</source>
        <translation>Le fessure di %1 la dividono in %2, che altre sezioni tengono insieme.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n pezzo</numerusform>
            <numerusform>%n pezzi</numerusform>
        </translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it.</source>
        <translation>Le fessure non lasciano nulla di %1.</translation>
    </message>
    <message>
        <source>%1 could not be cut out: what its slits leave of it could not be worked out. Nothing can be exported; its mass counts without slits.</source>
        <translation>Impossibile ritagliare %1: non si è potuto calcolare che cosa ne lasciano le fessure. Non si può esportare nulla; la massa conta senza fessure.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: sections of it are missing. Nothing can be exported.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Impossibile calcolare %1: mancano delle sezioni. Non si può esportare nulla.</translation>
    </message>
    <message>
        <source>Divided by slits</source>
        <translation>Divisa dalle fessure</translation>
    </message>
    <message>
        <source>Nothing left</source>
        <translation>Non resta nulla</translation>
    </message>
    <message>
        <source>Not cut out</source>
        <translation>Non ritagliata</translation>
    </message>
    <message>
        <source>Operation failed</source>
        <translation>Operazione non riuscita</translation>
    </message>
    <message>
        <source>Make it wider there</source>
        <translation>Allarga in quel punto</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>%n sezione spostata</numerusform>
            <numerusform>%n sezioni spostate</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n sezione spostata in basso di %1</numerusform>
            <numerusform>%n sezioni spostate in basso di %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>%n sezione spostata in alto di %1</numerusform>
            <numerusform>%n sezioni spostate in alto di %1</numerusform>
        </translation>
    </message>
    <message>
        <source>1 joint flipped</source>
        <translation>1 incastro invertito</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>%n incastro invertito</numerusform>
            <numerusform>%n incastri invertiti</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 becomes %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 passa a uno spessore di %2</translation>
    </message>
    <message>
        <source>The slits of 1 joint meet elsewhere</source>
        <translation>Le fessure di 1 incastro si incontrano altrove</translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>Le fessure di %n incastro si incontrano altrove</numerusform>
            <numerusform>Le fessure di %n incastri si incontrano altrove</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>%1 spostata di %2</translation>
    </message>
    <message>
        <source>%1 turned by %2</source>
        <extracomment>%1 is the name of a section, %2 an angle</extracomment>
        <translation>%1 ruotata di %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections turned</source>
        <translation>
            <numerusform>%n sezione ruotata</numerusform>
            <numerusform>%n sezioni ruotate</numerusform>
        </translation>
    </message>
    <message>
        <source>a new joint with a slit of %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>un nuovo incastro con una fessura di %1</translation>
    </message>
    <message>
        <source>1 new joint</source>
        <translation>1 nuovo incastro</translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>%n nuovo incastro</numerusform>
            <numerusform>%n nuovi incastri</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reshaped</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 con un altro contorno</translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>%n sezione con un altro contorno</numerusform>
            <numerusform>%n sezioni con un altro contorno</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 added</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 aggiunta</translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>%n sezione aggiunta</numerusform>
            <numerusform>%n sezioni aggiunte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 eliminata</translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>%n sezione eliminata</numerusform>
            <numerusform>%n sezioni eliminate</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing more is cut through</source>
        <translation>nient’altro viene tagliato da parte a parte</translation>
    </message>
    <message>
        <source>1 problem solved</source>
        <translation>1 problema risolto</translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>%n problema risolto</numerusform>
            <numerusform>%n problemi risolti</numerusform>
        </translation>
    </message>
    <message>
        <source>then: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Holds 350 g&quot;</extracomment>
        <translation>poi: %1</translation>
    </message>
    <message>
        <source>new: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Too little material&quot;</extracomment>
        <translation>nuovo: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>%n nuova osservazione</numerusform>
            <numerusform>%n nuove osservazioni</numerusform>
        </translation>
    </message>
    <message>
        <source>beside its slit for %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>accanto alla fessura per %1</translation>
    </message>
    <message>
        <source>where it joins %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>dove si unisce a %1</translation>
    </message>
    <message>
        <source>at an inner corner</source>
        <extracomment>where a part may break</extracomment>
        <translation>in un angolo interno</translation>
    </message>
    <message>
        <source>at its neck</source>
        <extracomment>where a part may break</extracomment>
        <translation>nella strozzatura</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n sezione</numerusform>
            <numerusform>%n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#x202f;N</translation>
    </message>
    <message>
        <source>Joined in rings</source>
        <translation>Collegate ad anelli</translation>
    </message>
    <message>
        <source>In the ground. %1 reaches %2 below it.</source>
        <translation>Nel suolo. %1 arriva %2 più in basso.</translation>
    </message>
    <message>
        <source>In the ground. %1 reach up to %2 below it.</source>
        <translation>Nel suolo. %1 arrivano fino a %2 più in basso.</translation>
    </message>
    <message>
        <source>In the ground</source>
        <translation>Nel suolo</translation>
    </message>
    <message>
        <source>Shift the planes by %1 %</source>
        <extracomment>of the slices of a mesh; %1 is a number, a part of the distance between two of them</extracomment>
        <translation>Sposta i piani del %1 %</translation>
    </message>
    <message>
        <source>One plane more each way</source>
        <translation>Un piano in più per direzione</translation>
    </message>
    <message>
        <source>Fits the sheets and offcuts that there are.</source>
        <translation>Entra nelle lastre e nei ritagli che ci sono.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>Al massimo %n lastra</numerusform>
            <numerusform>Al massimo %n lastre</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1.</source>
        <translation>Entra nella lastra. %1.</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2.</source>
        <translation>Entra nella lastra. %1 da %2.</translation>
    </message>
    <message>
        <source>Sections overlap slightly</source>
        <translation>Sezioni appena sovrapposte</translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>Le lastre possono non bastare. Serve fino a %n lastra di %1, e ce ne sono %2.</numerusform>
            <numerusform>Le lastre possono non bastare. Servono fino a %n lastre di %1, e ce ne sono %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>May run out of sheets</source>
        <translation>Le lastre possono non bastare</translation>
    </message>
    <message>
        <source>Look in Sheets how closely the parts can lie.</source>
        <translation>Guarda in Lastre quanto vicini possono stare i pezzi.</translation>
    </message>
    <message>
        <source>Planes every %1</source>
        <extracomment>of the slices of a mesh; %1 is a length</extracomment>
        <translation>Piani ogni %1</translation>
    </message>
    <message>
        <source>%1, shifted by %2 %</source>
        <extracomment>of the slices of a mesh; %1 is such as &quot;One plane fewer each way&quot;</extracomment>
        <translation>%1, spostato del %2 %</translation>
    </message>
    <message>
        <source>One plane more</source>
        <translation>Un piano in più</translation>
    </message>
    <message>
        <source>One plane fewer each way</source>
        <translation>Un piano in meno per direzione</translation>
    </message>
    <message>
        <source>One plane fewer</source>
        <translation>Un piano in meno</translation>
    </message>
    <message>
        <source>Two planes more each way</source>
        <translation>Due piani in più per direzione</translation>
    </message>
    <message>
        <source>Two planes more</source>
        <translation>Due piani in più</translation>
    </message>
    <message>
        <source>Two planes fewer each way</source>
        <translation>Due piani in meno per direzione</translation>
    </message>
    <message>
        <source>Two planes fewer</source>
        <translation>Due piani in meno</translation>
    </message>
    <message>
        <source>None of the shifts and numbers of planes that were tried lets them slide together. Bake the slices and shorten one of them, or leave it out.</source>
        <translation>Nessuno spostamento e nessun numero di piani provato le fa scorrere insieme. Converti le fette e accorcia una di loro, oppure toglila.</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>The model is here to be adjusted; “Edit the design” brings all back</source>
        <translation>Questo modello è qui per essere adattato; “Modifica il progetto” fa tornare tutto</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Apri un modello, anche di FlatFab</translation>
    </message>
    <message>
        <source>&amp;Insert model…</source>
        <translation>Inserisci modello…</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Inserisci</translation>
    </message>
    <message>
        <source>Add the sections of another model to this one</source>
        <translation>Aggiungi le sezioni di un altro modello a questo</translation>
    </message>
    <message>
        <source>Te&amp;mplate to draw over…</source>
        <translation>Riferimento da ricalcare…</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Riferimento</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections over</source>
        <translation>Leggi una mesh, un’immagine o un disegno su cui disegnare sezioni</translation>
    </message>
    <message>
        <source>Add to the &amp;library</source>
        <translation>Aggiungi alla libreria</translation>
    </message>
    <message>
        <source>To library</source>
        <translation>In libreria</translation>
    </message>
    <message>
        <source>Keep the selection in the library, for other models</source>
        <translation>Conserva la selezione nella libreria, per altri modelli</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Salva</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salva</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Salva il modello</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salva con nome…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Con nome</translation>
    </message>
    <message>
        <source>Save the model under another name</source>
        <translation>Salva il modello con un altro nome</translation>
    </message>
    <message>
        <source>&amp;Export cutting files…</source>
        <translation>Esporta file di taglio…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Esporta…</translation>
    </message>
    <message>
        <source>Write the parts to a file for the laser cutter</source>
        <translation>Scrivi i pezzi in un file per la macchina a taglio laser</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Esporta di nuovo</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Esporta di nuovo</translation>
    </message>
    <message>
        <source>Write the same file again, with the same choices</source>
        <translation>Scrivi di nuovo lo stesso file, con le stesse scelte</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Torna alla versione salvata</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Torna indietro</translation>
    </message>
    <message>
        <source>Go back to the model as it is in its file; Undo brings the changes back</source>
        <translation>Torna al modello com’è nel suo file; con Annulla le modifiche ritornano</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>Impostazioni…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Units, colours, language, files and shortcuts</source>
        <translation>Unità, colori, lingua, file e scorciatoie</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>Scorciatoie da tastiera…</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Scorciatoie</translation>
    </message>
    <message>
        <source>See which keys do what, and choose your own</source>
        <translation>Guarda quali tasti fanno che cosa e scegli i tuoi</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Chiudi finestra</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Close this window; others stay open</source>
        <translation>Chiudi questa finestra; le altre restano aperte</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Esci</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Esci</translation>
    </message>
    <message>
        <source>Close all windows and the program</source>
        <translation>Chiudi tutte le finestre e il programma</translation>
    </message>
    <message>
        <source>Go to Properties</source>
        <translation>Vai alle proprietà</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Proprietà</translation>
    </message>
    <message>
        <source>Go to the first field of the selection; in the view, Enter does the same</source>
        <translation>Vai al primo campo della selezione; nella vista fa lo stesso Invio</translation>
    </message>
    <message>
        <source>Hide all panels</source>
        <translation>Nascondi tutti i pannelli</translation>
    </message>
    <message>
        <source>Hide panels</source>
        <translation>Nascondi</translation>
    </message>
    <message>
        <source>Hide or show the panels at the sides</source>
        <translation>Nascondi o mostra i pannelli ai lati</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Schermo intero</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Schermo intero</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>Riempi lo schermo con la finestra</translation>
    </message>
    <message>
        <source>Reset &amp;window</source>
        <translation>Reimposta la finestra</translation>
    </message>
    <message>
        <source>Reset window</source>
        <translation>Reimposta la finestra</translation>
    </message>
    <message>
        <source>Put all panels back in their original places</source>
        <translation>Rimetti tutti i pannelli al loro posto originale</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Parte successiva della finestra</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>Parte successiva</translation>
    </message>
    <message>
        <source>Go to the next part of the window: tool bar, left, view, right</source>
        <translation>Vai alla parte successiva della finestra: barra degli strumenti, sinistra, vista, destra</translation>
    </message>
    <message>
        <source>Previous part of the win&amp;dow</source>
        <translation>Parte precedente della finestra</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>Parte precedente</translation>
    </message>
    <message>
        <source>Go back to the part of the window before this one</source>
        <translation>Torna alla parte precedente della finestra</translation>
    </message>
    <message>
        <source>&amp;Next problem</source>
        <translation>Problema successivo</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>Problema successivo</translation>
    </message>
    <message>
        <source>Select the sections of the next problem and show them</source>
        <translation>Seleziona le sezioni del problema successivo e mostrale</translation>
    </message>
    <message>
        <source>&amp;Previous problem</source>
        <translation>Problema precedente</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>Problema precedente</translation>
    </message>
    <message>
        <source>Select the sections of the problem before this one</source>
        <translation>Seleziona le sezioni del problema precedente</translation>
    </message>
    <message>
        <source>Show the &amp;steps</source>
        <translation>Mostra i passi</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Passi</translation>
    </message>
    <message>
        <source>Show step by step how the model is put together</source>
        <translation>Mostra passo dopo passo come si monta il modello</translation>
    </message>
    <message>
        <source>Stoc&amp;ks…</source>
        <translation>Materiali…</translation>
    </message>
    <message>
        <source>Stocks</source>
        <translation>Materiali</translation>
    </message>
    <message>
        <source>Sheet materials: thickness, strength, kerf and sheet size</source>
        <translation>Materiali in lastra: spessore, resistenza, solco di taglio e formato della lastra</translation>
    </message>
    <message>
        <source>&amp;Fit coupon…</source>
        <translation>Provino d’incastro…</translation>
    </message>
    <message>
        <source>Fit coupon</source>
        <translation>Provino</translation>
    </message>
    <message>
        <source>Write a test piece that tells which slits fit and how wide the machine cuts</source>
        <translation>Scrivi un pezzo di prova che dice quali fessure vanno bene e quanto largo taglia la macchina</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>Lastre</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Lastre</translation>
    </message>
    <message>
        <source>Show the parts on their sheets, as they will be cut</source>
        <translation>Mostra i pezzi sulle loro lastre, come saranno tagliati</translation>
    </message>
    <message>
        <source>Go to the values</source>
        <translation>Vai ai valori</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valori</translation>
    </message>
    <message>
        <source>Adjust the values that numbers of the model are made of</source>
        <translation>Regola i valori da cui dipendono i numeri del modello</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nuovo valore</translation>
    </message>
    <message>
        <source>A number with a name, which number fields take</source>
        <translation>Un numero con un nome, da usare nei campi numerici</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Trova un comando…</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Trova</translation>
    </message>
    <message>
        <source>Type to find anything that the program can do</source>
        <translation>Scrivi per trovare tutto ciò che il programma sa fare</translation>
    </message>
    <message>
        <source>First ste&amp;ps</source>
        <translation>Primi passi</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Primi passi</translation>
    </message>
    <message>
        <source>How a model is made, step by step, with pictures</source>
        <translation>Come nasce un modello, passo dopo passo, con le immagini</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>Pagina iniziale</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Pagina iniziale</translation>
    </message>
    <message>
        <source>Recent models and samples</source>
        <translation>Modelli recenti ed esempi</translation>
    </message>
    <message>
        <source>&amp;About FlatFitFab</source>
        <translation>Informazioni su FlatFitFab</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Informazioni</translation>
    </message>
    <message>
        <source>What this program is, its version and its licences</source>
        <translation>Che cos’è questo programma, la versione e le licenze</translation>
    </message>
    <message>
        <source>It has not been exported yet</source>
        <translation>Non è ancora stato esportato</translation>
    </message>
    <message>
        <source>It has never been saved</source>
        <translation>Non è mai stato salvato</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>Nulla è cambiato dall’ultimo salvataggio</translation>
    </message>
    <message>
        <source>Stren&amp;gth map</source>
        <translation>Mappa di resistenza</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Mappa di resistenza</translation>
    </message>
    <message>
        <source>Colour a section by the mass that each place of it can hold</source>
        <translation>Colora una sezione secondo la massa che ogni suo punto può reggere</translation>
    </message>
    <message>
        <source>Select the section to look at first</source>
        <translation>Seleziona prima la sezione da esaminare</translation>
    </message>
    <message>
        <source>Select one section first</source>
        <translation>Seleziona prima una sezione</translation>
    </message>
    <message>
        <source>No joint is selected: select a section, then one of its joints</source>
        <translation>Nessun incastro selezionato: seleziona una sezione, poi uno dei suoi incastri</translation>
    </message>
    <message>
        <source>There is no other section</source>
        <translation>Non c’è nessun’altra sezione</translation>
    </message>
    <message>
        <source>No operation is selected</source>
        <translation>Nessuna operazione selezionata</translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation>Non c’è ancora nessuna sezione</translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation>Nessuna sezione selezionata</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Taglia</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Taglia</translation>
    </message>
    <message>
        <source>Copy the selected sections and delete them</source>
        <translation>Copia le sezioni selezionate ed eliminale</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>Copy the selected sections, also for other windows and programs</source>
        <translation>Copia le sezioni selezionate, anche per altre finestre e programmi</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Incolla</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Incolla</translation>
    </message>
    <message>
        <source>Add the sections that were copied, or a picture to draw over</source>
        <translation>Aggiungi le sezioni copiate o un’immagine da ricalcare</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>Duplica</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplica</translation>
    </message>
    <message>
        <source>Put a copy of the selected sections beside them</source>
        <translation>Metti una copia delle sezioni selezionate lì accanto</translation>
    </message>
    <message>
        <source>Across &amp;X</source>
        <translation>Rispetto a X</translation>
    </message>
    <message>
        <source>Mirror X</source>
        <translation>Specchia X</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where X is 0</source>
        <translation>Metti un’immagine specchiata delle sezioni selezionate dall’altra parte del piano dove X è 0</translation>
    </message>
    <message>
        <source>Across &amp;Y</source>
        <translation>Rispetto a Y</translation>
    </message>
    <message>
        <source>Mirror Y</source>
        <translation>Specchia Y</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Y is 0</source>
        <translation>Metti un’immagine specchiata delle sezioni selezionate dall’altra parte del piano dove Y è 0</translation>
    </message>
    <message>
        <source>Across &amp;Z</source>
        <translation>Rispetto a Z</translation>
    </message>
    <message>
        <source>Mirror Z</source>
        <translation>Specchia Z</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Z is 0</source>
        <translation>Metti un’immagine specchiata delle sezioni selezionate dall’altra parte del piano dove Z è 0</translation>
    </message>
    <message>
        <source>Across a &amp;section…</source>
        <translation>Rispetto a una sezione…</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Specchio</translation>
    </message>
    <message>
        <source>Click a section: a mirror image of the selected ones comes on its other side</source>
        <translation>Fai clic su una sezione: un’immagine specchiata di quelle selezionate va dall’altra parte</translation>
    </message>
    <message>
        <source>Sections from SV&amp;G…</source>
        <translation>Sezioni da SVG…</translation>
    </message>
    <message>
        <source>From SVG</source>
        <translation>Da SVG</translation>
    </message>
    <message>
        <source>A section for every outline of a drawing</source>
        <translation>Una sezione per ogni sagoma di un disegno</translation>
    </message>
    <message>
        <source>&amp;Contour from SVG…</source>
        <translation>Contorno da SVG…</translation>
    </message>
    <message>
        <source>Contour from SVG</source>
        <translation>Contorno da SVG</translation>
    </message>
    <message>
        <source>The largest outline of a drawing in place of the selected section&apos;s</source>
        <translation>La sagoma più grande di un disegno al posto del contorno della sezione selezionata</translation>
    </message>
    <message>
        <source>&amp;Holes from SVG…</source>
        <translation>Fori da SVG…</translation>
    </message>
    <message>
        <source>Holes from SVG</source>
        <translation>Fori da SVG</translation>
    </message>
    <message>
        <source>A hole of the selected section for every outline of a drawing</source>
        <translation>Un foro nella sezione selezionata per ogni sagoma di un disegno</translation>
    </message>
    <message>
        <source>&amp;Marks from SVG…</source>
        <translation>Segni da SVG…</translation>
    </message>
    <message>
        <source>Marks from SVG</source>
        <translation>Segni da SVG</translation>
    </message>
    <message>
        <source>The lines of a drawing, engraved or scored on the selected section</source>
        <translation>Le linee di un disegno, incise o cordonate sulla sezione selezionata</translation>
    </message>
    <message>
        <source>&amp;Draw a shape</source>
        <translation>Disegna una forma</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Drag a circle, rectangle or the like out of its middle</source>
        <translation>Trascina un cerchio, un rettangolo o simili a partire dal centro</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>Cerchio</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cerchio</translation>
    </message>
    <message>
        <source>By numbers: a hole in the selected section, or a section of its own</source>
        <translation>Con i numeri: un foro nella sezione selezionata o una sezione a sé</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>Ellisse</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellisse</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>Rettangolo</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rettangolo</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>Poligono</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Poligono</translation>
    </message>
    <message>
        <source>&amp;Star</source>
        <translation>Stella</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stella</translation>
    </message>
    <message>
        <source>S&amp;lot</source>
        <translation>Asola</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Asola</translation>
    </message>
    <message>
        <source>Move a te&amp;mplate</source>
        <translation>Sposta un riferimento</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Maniglie</translation>
    </message>
    <message>
        <source>Move, turn and scale the template with handles or numbers</source>
        <translation>Sposta, ruota e scala il riferimento con le maniglie o con i numeri</translation>
    </message>
    <message>
        <source>Size a template by a &amp;line</source>
        <translation>Scala un riferimento con una linea</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Con linea</translation>
    </message>
    <message>
        <source>Draw a line over the template and say how long it is</source>
        <translation>Traccia una linea sul riferimento e indica quanto è lunga</translation>
    </message>
    <message>
        <source>There is no picture and no drawing: add one first</source>
        <translation>Non c’è nessuna immagine e nessun disegno: aggiungine prima uno</translation>
    </message>
    <message>
        <source>There is no template: add a mesh or a picture first</source>
        <translation>Non c’è nessun riferimento: aggiungi prima una mesh o un’immagine</translation>
    </message>
    <message>
        <source>Flip the slits of the &amp;joint</source>
        <translation>Inverti le fessure dell’incastro</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Inverti</translation>
    </message>
    <message>
        <source>Let the slits of the selected joint open to the other side</source>
        <translation>Fai aprire le fessure dell’incastro selezionato dall’altra parte</translation>
    </message>
    <message>
        <source>Restore a&amp;utomatic settings</source>
        <translation>Ripristina le impostazioni automatiche</translation>
    </message>
    <message>
        <source>Restore automatic</source>
        <translation>Automatico</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points of the selected joint again</source>
        <translation>Lascia di nuovo scegliere al programma tipo, direzione e punti d’incontro dell’incastro selezionato</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>In questo incastro nulla è impostato a mano</translation>
    </message>
    <message>
        <source>Add &amp;weight</source>
        <translation>Aggiungi peso</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Put a weight on a section to see what it can hold</source>
        <translation>Metti un peso su una sezione per vedere quanto regge</translation>
    </message>
    <message>
        <source>Add p&amp;ush</source>
        <translation>Aggiungi spinta</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Spinta</translation>
    </message>
    <message>
        <source>Push or pull a section in one place to see what it can hold</source>
        <translation>Spingi o tira una sezione in un punto per vedere quanto regge</translation>
    </message>
    <message>
        <source>Pull &amp;here</source>
        <translation>Tira qui</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Tira</translation>
    </message>
    <message>
        <source>Pull a section with the mouse to see what happens; nothing is kept</source>
        <translation>Tira una sezione con il mouse per vedere che cosa succede; non resta nulla</translation>
    </message>
    <message>
        <source>Nothing acts on the model: add a weight or a push first</source>
        <translation>Nulla agisce sul modello: aggiungi prima un peso o una spinta</translation>
    </message>
    <message>
        <source>There is no mesh that could be pulled</source>
        <translation>Non c’è nessuna mesh da attrarre</translation>
    </message>
    <message>
        <source>Add te&amp;xt or lines to engrave</source>
        <translation>Aggiungi testo o linee da incidere</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Incidi</translation>
    </message>
    <message>
        <source>Write or draw on a section, to be engraved or scored</source>
        <translation>Scrivi o disegna su una sezione, da incidere o cordonare</translation>
    </message>
    <message>
        <source>&amp;Engrave</source>
        <translation>Incidi</translation>
    </message>
    <message>
        <source>What is drawn next is engraved</source>
        <translation>Ciò che disegni ora viene inciso</translation>
    </message>
    <message>
        <source>&amp;Score</source>
        <translation>Cordona</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Cordona</translation>
    </message>
    <message>
        <source>What is drawn next is scored, to fold or break along</source>
        <translation>Ciò che disegni ora viene cordonato, per piegare o spezzare lungo la linea</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Measure between two places; keep the length, or scale the model to it</source>
        <translation>Misura tra due punti; conserva la lunghezza o scala il modello di conseguenza</translation>
    </message>
    <message>
        <source>Scale to a &amp;length</source>
        <translation>Scala a una lunghezza</translation>
    </message>
    <message>
        <source>Scale to a length</source>
        <translation>Scala a una lunghezza</translation>
    </message>
    <message>
        <source>Set a length and scale the model to match</source>
        <translation>Imposta una lunghezza e scala il modello di conseguenza</translation>
    </message>
    <message>
        <source>Keep t&amp;he length</source>
        <translation>Conserva la lunghezza</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserva</translation>
    </message>
    <message>
        <source>Keep showing this length</source>
        <translation>Continua a mostrare questa lunghezza</translation>
    </message>
    <message>
        <source>Rem&amp;ove this dimension</source>
        <translation>Rimuovi questa quota</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Remove this dimension</source>
        <translation>Rimuovi questa quota</translation>
    </message>
    <message>
        <source>Nothing is measured</source>
        <translation>Non è misurato nulla</translation>
    </message>
    <message>
        <source>No dimension is picked: click one with Measure</source>
        <translation>Nessuna quota scelta: fai clic su una con Misura</translation>
    </message>
    <message>
        <source>&amp;Mirror…</source>
        <translation>Specchia…</translation>
    </message>
    <message>
        <source>Mirror the selected sections, or one side of the model to the other</source>
        <translation>Specchia le sezioni selezionate, o un lato del modello sull’altro</translation>
    </message>
    <message>
        <source>Mirror left and right (X)</source>
        <translation>Specchia sinistra e destra (X)</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Mirror across the plane where X is 0</source>
        <translation>Specchia rispetto al piano dove X è 0</translation>
    </message>
    <message>
        <source>Mirror up and down (Y)</source>
        <translation>Specchia alto e basso (Y)</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Mirror across the plane where Y is 0</source>
        <translation>Specchia rispetto al piano dove Y è 0</translation>
    </message>
    <message>
        <source>Mirror front and back (Z)</source>
        <translation>Specchia fronte e retro (Z)</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Mirror across the plane where Z is 0</source>
        <translation>Specchia rispetto al piano dove Z è 0</translation>
    </message>
    <message>
        <source>Mirror across a section</source>
        <translation>Specchia rispetto a una sezione</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sezione</translation>
    </message>
    <message>
        <source>Mirror across the plane of the section that is clicked</source>
        <translation>Specchia rispetto al piano della sezione su cui fai clic</translation>
    </message>
    <message>
        <source>Mirror a copy of the selection</source>
        <translation>Specchia una copia della selezione</translation>
    </message>
    <message>
        <source>Add a mirror image of the selected sections</source>
        <translation>Aggiungi un’immagine specchiata delle sezioni selezionate</translation>
    </message>
    <message>
        <source>Keep both sides the same</source>
        <translation>Mantieni uguali i due lati</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Due lati</translation>
    </message>
    <message>
        <source>Mirror everything drawn on one side, now and later</source>
        <translation>Specchia tutto ciò che è disegnato su un lato, ora e in seguito</translation>
    </message>
    <message>
        <source>Make symmetric once</source>
        <translation>Rendi simmetrico una volta</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Una volta</translation>
    </message>
    <message>
        <source>Copy one side to the other; later edits are not copied</source>
        <translation>Copia un lato sull’altro; le modifiche successive non vengono copiate</translation>
    </message>
    <message>
        <source>Mirror as shown</source>
        <translation>Specchia come mostrato</translation>
    </message>
    <message>
        <source>Do what is shown</source>
        <translation>Esegui ciò che è mostrato</translation>
    </message>
    <message>
        <source>Choose Mirror first</source>
        <translation>Scegli prima Specchia</translation>
    </message>
    <message>
        <source>Ta&amp;ke the offered shape</source>
        <translation>Usa la forma proposta</translation>
    </message>
    <message>
        <source>Offered shape</source>
        <translation>Usa forma</translation>
    </message>
    <message>
        <source>Turn what was just drawn into the offered circle, ellipse, straight lines or right angles, or move its slit in from the edge</source>
        <translation>Trasforma ciò che hai appena disegnato nel cerchio, nell’ellisse, nelle linee dritte o negli angoli retti proposti, o allontana la sua fessura dal bordo</translation>
    </message>
    <message>
        <source>&amp;Take the whole guide</source>
        <translation>Usa tutta la guida</translation>
    </message>
    <message>
        <source>Take the guide</source>
        <translation>Usa guida</translation>
    </message>
    <message>
        <source>Make the section of all that its plane cuts of a template, with its holes</source>
        <translation>Fai la sezione con tutto ciò che il suo piano taglia di un riferimento, fori compresi</translation>
    </message>
    <message>
        <source>Nothing is offered for what was just drawn</source>
        <translation>Non è proposto nulla per ciò che hai appena disegnato</translation>
    </message>
    <message>
        <source>The plane that is drawn on cuts no template</source>
        <translation>Il piano su cui disegni non taglia nessun riferimento</translation>
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
        <translation>Ripeti una sezione in fila lungo un’altra</translation>
    </message>
    <message>
        <source>&amp;Revolve along contour</source>
        <translation>Giro lungo il contorno</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Repeat a section round the contour of another one</source>
        <translation>Ripeti una sezione tutt’intorno al contorno di un’altra</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>Transizione</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Transizione</translation>
    </message>
    <message>
        <source>Interpolate between sections</source>
        <translation>Interpola tra sezioni</translation>
    </message>
    <message>
        <source>Br&amp;anch</source>
        <translation>Ramificazione</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ramificazione</translation>
    </message>
    <message>
        <source>Grow copies of a section out of itself, like a tree</source>
        <translation>Fai crescere da una sezione copie di sé stessa, come un albero</translation>
    </message>
    <message>
        <source>&amp;Grid with connectors</source>
        <translation>Griglia con connettori</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Griglia</translation>
    </message>
    <message>
        <source>Divide a section that is too large for the sheet</source>
        <translation>Dividi una sezione troppo grande per la lastra</translation>
    </message>
    <message>
        <source>Ra&amp;dial contour</source>
        <translation>Contorno radiale</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radiale</translation>
    </message>
    <message>
        <source>Turn a section into a circle, a star or a gear, or cut such holes into it</source>
        <translation>Trasforma una sezione in un cerchio, una stella o un ingranaggio, o tagliaci fori così</translation>
    </message>
    <message>
        <source>&amp;Mirror model</source>
        <translation>Specchia il modello</translation>
    </message>
    <message>
        <source>Repeat everything drawn on one side on the other</source>
        <translation>Ripeti sull’altro lato tutto ciò che è disegnato su uno</translation>
    </message>
    <message>
        <source>Ro&amp;tational symmetry</source>
        <translation>Simmetria rotazionale</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Rotazionale</translation>
    </message>
    <message>
        <source>Repeat everything drawn once all round an axis</source>
        <translation>Ripeti tutt’intorno a un asse ciò che è disegnato una volta</translation>
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
        <translation>Ripeti sezioni lungo una linea nello spazio</translation>
    </message>
    <message>
        <source>&amp;Slices of a mesh</source>
        <translation>Fette di una mesh</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Fette</translation>
    </message>
    <message>
        <source>Cut a mesh that is drawn over into sections that follow it</source>
        <translation>Taglia la mesh che ricalchi in sezioni che la seguono</translation>
    </message>
    <message>
        <source>Make symmetric &amp;now</source>
        <translation>Rendi simmetrico ora</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simmetrico</translation>
    </message>
    <message>
        <source>Mirror one side to the other, once</source>
        <translation>Specchia un lato sull’altro, una sola volta</translation>
    </message>
    <message>
        <source>&amp;Switch off or on</source>
        <translation>Disattiva o riattiva</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Attiva</translation>
    </message>
    <message>
        <source>Switch the selected operation off, or on again</source>
        <translation>Disattiva l’operazione selezionata o riattivala</translation>
    </message>
    <message>
        <source>Earlier in the &amp;order</source>
        <translation>Prima nell’ordine</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Prima</translation>
    </message>
    <message>
        <source>Run the selected operation before the one above it</source>
        <translation>Esegui l’operazione selezionata prima di quella che la precede</translation>
    </message>
    <message>
        <source>Lat&amp;er in the order</source>
        <translation>Dopo nell’ordine</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Dopo</translation>
    </message>
    <message>
        <source>Run the selected operation after the one below it</source>
        <translation>Esegui l’operazione selezionata dopo quella che la segue</translation>
    </message>
    <message>
        <source>Ba&amp;ke into sections</source>
        <translation>Converti in sezioni</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Converti</translation>
    </message>
    <message>
        <source>Turn what the selected operation makes into drawn sections</source>
        <translation>Trasforma in sezioni disegnate ciò che crea l’operazione selezionata</translation>
    </message>
    <message>
        <source>There is no mesh to slice: add one first</source>
        <translation>Non c’è nessuna mesh da affettare: aggiungine prima una</translation>
    </message>
    <message>
        <source>It is the first one</source>
        <translation>È già la prima</translation>
    </message>
    <message>
        <source>It is the last one</source>
        <translation>È già l’ultima</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Aggancio</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Aggancio</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines and grid</source>
        <translation>Aggancia a punti, linee di allineamento e griglia</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>Penna</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Penna</translation>
    </message>
    <message>
        <source>Draw with clicks instead of one stroke: set points, drag to bend</source>
        <translation>Disegna con i clic invece che con un solo tratto: inserisci punti, trascina per curvare</translation>
    </message>
    <message>
        <source>No number is typed</source>
        <translation>Non è scritto nessun numero</translation>
    </message>
    <message>
        <source>Re&amp;move holes</source>
        <translation>Rimuovi i fori</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>Senza fori</translation>
    </message>
    <message>
        <source>Close all holes of the selected sections</source>
        <translation>Chiudi tutti i fori delle sezioni selezionate</translation>
    </message>
    <message>
        <source>&amp;Add point</source>
        <translation>Aggiungi punto</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Aggiungi punto</translation>
    </message>
    <message>
        <source>Add a control point under the cursor, or beside the selected one</source>
        <translation>Aggiungi un punto di controllo sotto il cursore o accanto a quello selezionato</translation>
    </message>
    <message>
        <source>De&amp;lete point</source>
        <translation>Elimina punto</translation>
    </message>
    <message>
        <source>Delete point</source>
        <translation>Elimina punto</translation>
    </message>
    <message>
        <source>Delete the selected control points</source>
        <translation>Elimina i punti di controllo selezionati</translation>
    </message>
    <message>
        <source>Smoo&amp;th point</source>
        <translation>Punto liscio</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Liscio</translation>
    </message>
    <message>
        <source>Make the contour smooth at the selected points</source>
        <translation>Rendi liscio il contorno nei punti selezionati</translation>
    </message>
    <message>
        <source>S&amp;ymmetric point</source>
        <translation>Punto simmetrico</translation>
    </message>
    <message>
        <source>Make the contour smooth, with handles of equal length on both sides</source>
        <translation>Rendi liscio il contorno, con maniglie della stessa lunghezza sui due lati</translation>
    </message>
    <message>
        <source>&amp;Corner point</source>
        <translation>Punto ad angolo</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Make the selected points corners</source>
        <translation>Trasforma in angoli i punti selezionati</translation>
    </message>
    <message>
        <source>No point of a contour is selected</source>
        <translation>Nessun punto di un contorno selezionato</translation>
    </message>
    <message>
        <source>Select one section whose contour can be edited</source>
        <translation>Seleziona una sezione con il contorno modificabile</translation>
    </message>
    <message>
        <source>The selection has no holes</source>
        <translation>La selezione non ha fori</translation>
    </message>
    <message>
        <source>Move &amp;and turn</source>
        <translation>Sposta e ruota</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Sposta</translation>
    </message>
    <message>
        <source>Move, turn and scale with handles or numbers</source>
        <translation>Sposta, ruota e scala con le maniglie o con i numeri</translation>
    </message>
    <message>
        <source>&amp;Along world axes</source>
        <translation>Lungo gli assi globali</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Assi globali</translation>
    </message>
    <message>
        <source>Move along the world&apos;s axes, not in the plane of the section</source>
        <translation>Sposta lungo gli assi globali, non nel piano della sezione</translation>
    </message>
    <message>
        <source>&amp;Move attached sections</source>
        <translation>Sposta le sezioni attaccate</translation>
    </message>
    <message>
        <source>Move attached</source>
        <translation>Attaccate</translation>
    </message>
    <message>
        <source>Sections that were drawn on this one move with it</source>
        <translation>Le sezioni disegnate su questa si spostano con lei</translation>
    </message>
    <message>
        <source>&amp;Put on another section…</source>
        <translation>Metti su un’altra sezione…</translation>
    </message>
    <message>
        <source>Put on</source>
        <translation>Metti su</translation>
    </message>
    <message>
        <source>Click the section to put the selected one on</source>
        <translation>Fai clic sulla sezione su cui mettere quella selezionata</translation>
    </message>
    <message>
        <source>&amp;Free from its parent</source>
        <translation>Svincola dalla sezione madre</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Svincola</translation>
    </message>
    <message>
        <source>Unlink from its parent: it no longer moves with it or keeps its angle</source>
        <translation>Svincola dalla sezione madre: non si sposta più con lei e non mantiene più l’angolo</translation>
    </message>
    <message>
        <source>Ma&amp;ke orthogonal</source>
        <translation>Rendi perpendicolare</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>A squadra</translation>
    </message>
    <message>
        <source>Turn the section square to the one it is on</source>
        <translation>Ruota la sezione perpendicolare a quella su cui sta</translation>
    </message>
    <message>
        <source>Align to nearest a&amp;xis</source>
        <translation>Allinea all’asse più vicino</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Allinea</translation>
    </message>
    <message>
        <source>Turn the section so that it faces along a world axis</source>
        <translation>Ruota la sezione in modo che guardi lungo un asse globale</translation>
    </message>
    <message>
        <source>Lo&amp;ck</source>
        <translation>Blocca</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Blocca</translation>
    </message>
    <message>
        <source>Protect the selected sections from changes</source>
        <translation>Proteggi le sezioni selezionate dalle modifiche</translation>
    </message>
    <message>
        <source>Edit &amp;its source</source>
        <translation>Modifica l’originale</translation>
    </message>
    <message>
        <source>Edit source</source>
        <translation>Originale</translation>
    </message>
    <message>
        <source>Select the section that the selected one is made from</source>
        <translation>Seleziona la sezione da cui è fatta quella selezionata</translation>
    </message>
    <message>
        <source>Deta&amp;ch this one</source>
        <translation>Stacca questa</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Stacca</translation>
    </message>
    <message>
        <source>Turn the selected section into a drawn one; its operation still makes the others</source>
        <translation>Trasforma in sezione disegnata quella selezionata; la sua operazione crea ancora le altre</translation>
    </message>
    <message>
        <source>Lea&amp;ve this one out</source>
        <translation>Ometti questa</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Ometti</translation>
    </message>
    <message>
        <source>Leave the selected section out; its operation still makes the others</source>
        <translation>Ometti la sezione selezionata; la sua operazione crea ancora le altre</translation>
    </message>
    <message>
        <source>The selection is not on another section</source>
        <translation>La selezione non sta su un’altra sezione</translation>
    </message>
    <message>
        <source>The selection is made by an operation</source>
        <translation>La selezione è creata da un’operazione</translation>
    </message>
    <message>
        <source>The selection is not symmetric</source>
        <translation>La selezione non è simmetrica</translation>
    </message>
    <message>
        <source>The selection is drawn, not made by an operation</source>
        <translation>La selezione è disegnata, non creata da un’operazione</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Seleziona tutto</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Seleziona tutto</translation>
    </message>
    <message>
        <source>Select all sections</source>
        <translation>Seleziona tutte le sezioni</translation>
    </message>
    <message>
        <source>Select ne&amp;xt</source>
        <translation>Seleziona successiva</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Successiva</translation>
    </message>
    <message>
        <source>Select the next section</source>
        <translation>Seleziona la sezione successiva</translation>
    </message>
    <message>
        <source>Select pre&amp;vious</source>
        <translation>Seleziona precedente</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Precedente</translation>
    </message>
    <message>
        <source>Select the section before this one</source>
        <translation>Seleziona la sezione precedente</translation>
    </message>
    <message>
        <source>Select co&amp;nnected</source>
        <translation>Seleziona collegate</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Collegate</translation>
    </message>
    <message>
        <source>Select all sections that are connected to the selected ones</source>
        <translation>Seleziona tutte le sezioni collegate a quelle selezionate</translation>
    </message>
    <message>
        <source>&amp;Select parallel</source>
        <translation>Seleziona parallele</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallele</translation>
    </message>
    <message>
        <source>Select all sections parallel to the selected ones</source>
        <translation>Seleziona tutte le sezioni parallele a quelle selezionate</translation>
    </message>
    <message>
        <source>Select same stoc&amp;k</source>
        <translation>Seleziona stesso materiale</translation>
    </message>
    <message>
        <source>Same stock</source>
        <translation>Stesso materiale</translation>
    </message>
    <message>
        <source>Select all sections of the same stock as the selected ones</source>
        <translation>Seleziona tutte le sezioni dello stesso materiale di quelle selezionate</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>Nuovo</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuovo</translation>
    </message>
    <message>
        <source>Start a new model</source>
        <translation>Inizia un nuovo modello</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Annulla l’ultimo passo</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Rifai</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rifai</translation>
    </message>
    <message>
        <source>Redo the step that was undone</source>
        <translation>Rifai il passo annullato</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Delete the selected sections</source>
        <translation>Elimina le sezioni selezionate</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>Inserisci un punto</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nulla da annullare</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Annulla “%1”</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Nulla da rifare</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>Rifai “%1”</translation>
    </message>
    <message>
        <source>&amp;Unpin all parts</source>
        <translation>Libera tutti i pezzi</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Libera tutti</translation>
    </message>
    <message>
        <source>Let all parts be moved again when they are laid on sheets</source>
        <translation>Lascia spostare di nuovo tutti i pezzi quando vengono disposti sulle lastre</translation>
    </message>
    <message>
        <source>No part is pinned to its sheet</source>
        <translation>Nessun pezzo è fissato alla sua lastra</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>Pelle</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Pelle</translation>
    </message>
    <message>
        <source>Show the form that the sections suggest, as a surface over them</source>
        <translation>Mostra la forma che le sezioni suggeriscono, come superficie sopra di loro</translation>
    </message>
    <message>
        <source>Local &amp;symmetry</source>
        <translation>Simmetria locale</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simmetria</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it</source>
        <translation>Specchia un contorno rispetto alla sua fessura quando lo disegni su un solo lato</translation>
    </message>
    <message>
        <source>Cut flat at the &amp;ground</source>
        <translation>Taglia a filo del suolo</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Suolo</translation>
    </message>
    <message>
        <source>Cut off what is drawn below the ground</source>
        <translation>Taglia via ciò che disegni sotto il suolo</translation>
    </message>
    <message>
        <source>On the gr&amp;ound</source>
        <translation>Sul suolo</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Sul suolo</translation>
    </message>
    <message>
        <source>Draw a section that lies on the ground</source>
        <translation>Disegna una sezione distesa sul suolo</translation>
    </message>
    <message>
        <source>On the &amp;front plane</source>
        <translation>Sul piano frontale</translation>
    </message>
    <message>
        <source>On the front</source>
        <translation>Di fronte</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the front</source>
        <translation>Disegna una sezione verticale al centro, vista di fronte</translation>
    </message>
    <message>
        <source>On the s&amp;ide plane</source>
        <translation>Sul piano laterale</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>Di lato</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the side</source>
        <translation>Disegna una sezione verticale al centro, vista di lato</translation>
    </message>
    <message>
        <source>&amp;Parallel to the section</source>
        <translation>Parallela alla sezione</translation>
    </message>
    <message>
        <source>Draw a section parallel to the selected one</source>
        <translation>Disegna una sezione parallela a quella selezionata</translation>
    </message>
    <message>
        <source>&amp;Redraw contour</source>
        <translation>Ridisegna contorno</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>Ridisegna</translation>
    </message>
    <message>
        <source>Draw a new contour for the selected section</source>
        <translation>Disegna un nuovo contorno per la sezione selezionata</translation>
    </message>
    <message>
        <source>Draw a &amp;hole</source>
        <translation>Disegna un foro</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Foro</translation>
    </message>
    <message>
        <source>Draw a hole in the selected section</source>
        <translation>Disegna un foro nella sezione selezionata</translation>
    </message>
    <message>
        <source>Drop to gro&amp;und</source>
        <translation>Appoggia al suolo</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Appoggia</translation>
    </message>
    <message>
        <source>Set the model down on the ground</source>
        <translation>Posa il modello sul suolo</translation>
    </message>
    <message>
        <source>The model is on the ground already</source>
        <translation>Il modello poggia già sul suolo</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Condividi da adattare</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Condividi</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else</source>
        <translation>Chi apre il modello salvato vede la vista, i valori mostrati ed Esporta, e nient’altro</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Modifica il progetto</translation>
    </message>
    <message>
        <source>Others can adjust no value yet</source>
        <translation>Gli altri non possono ancora regolare nessun valore</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>Fronte</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Fronte</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Guarda di fronte</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Look from the top</source>
        <translation>Guarda dall’alto</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Guarda da destra</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Retro</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retro</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>Guarda da dietro</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>Basso</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Basso</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Guarda dal basso</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Guarda da sinistra</translation>
    </message>
    <message>
        <source>Next &amp;corner</source>
        <translation>Angolo successivo</translation>
    </message>
    <message>
        <source>Look from the next corner</source>
        <translation>Guarda dall’angolo successivo</translation>
    </message>
    <message>
        <source>Face the &amp;section</source>
        <translation>Guarda la sezione di fronte</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Frontale</translation>
    </message>
    <message>
        <source>Look straight at the selected section</source>
        <translation>Guarda dritto sulla sezione selezionata</translation>
    </message>
    <message>
        <source>Fit &amp;everything</source>
        <translation>Inquadra tutto</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Inquadra</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>Mostra tutto il modello</translation>
    </message>
    <message>
        <source>F&amp;it selection</source>
        <translation>Inquadra selezione</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>Inquadra selezione</translation>
    </message>
    <message>
        <source>Show the selected sections as large as possible</source>
        <translation>Mostra le sezioni selezionate il più grande possibile</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>Vista precedente</translation>
    </message>
    <message>
        <source>Go back to the view before this one</source>
        <translation>Torna alla vista precedente</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>Prospettiva</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Prospettiva</translation>
    </message>
    <message>
        <source>Show what is farther away smaller, as the eye sees it</source>
        <translation>Mostra più piccolo ciò che è più lontano, come lo vede l’occhio</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>Raggi X</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Raggi X</translation>
    </message>
    <message>
        <source>See through all sections, down to their slits</source>
        <translation>Guarda attraverso tutte le sezioni, fino alle fessure</translation>
    </message>
    <message>
        <source>Onl&amp;y the selection</source>
        <translation>Solo la selezione</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isola</translation>
    </message>
    <message>
        <source>Fade all other sections</source>
        <translation>Sbiadisci tutte le altre sezioni</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Nascondi</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Nascondi</translation>
    </message>
    <message>
        <source>Hide the selected sections</source>
        <translation>Nascondi le sezioni selezionate</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Mostra tutto</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostra tutto</translation>
    </message>
    <message>
        <source>Show the hidden sections again</source>
        <translation>Mostra di nuovo le sezioni nascoste</translation>
    </message>
    <message>
        <source>Cut view &amp;open</source>
        <translation>Vista in spaccato</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Spaccato</translation>
    </message>
    <message>
        <source>Cut the model open with a plane, to look inside</source>
        <translation>Taglia il modello con un piano, per guardarci dentro</translation>
    </message>
    <message>
        <source>&amp;Ground and shadow</source>
        <translation>Suolo e ombra</translation>
    </message>
    <message>
        <source>Show the ground with its grid and the model&apos;s shadow</source>
        <translation>Mostra il suolo con la griglia e l’ombra del modello</translation>
    </message>
    <message>
        <source>Stress &amp;lines</source>
        <translation>Linee di tensione</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Tensione</translation>
    </message>
    <message>
        <source>Show where the model is strained most</source>
        <translation>Mostra dove il modello è più sollecitato</translation>
    </message>
    <message>
        <source>No section is hidden</source>
        <translation>Nessuna sezione è nascosta</translation>
    </message>
    <message>
        <source>There is no view before this one</source>
        <translation>Non c’è nessuna vista precedente</translation>
    </message>
    <message>
        <source>The simple window does without it; Settings have the whole one</source>
        <translation>La finestra semplice ne fa a meno; nelle Impostazioni c’è quella completa</translation>
    </message>
    <message>
        <source>Your first model in 3 &amp;minutes</source>
        <translation>Il tuo primo modello in 3 minuti</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visita guidata</translation>
    </message>
    <message>
        <source>Draw, check and cut a model step by step, in an empty window</source>
        <translation>Disegnare, controllare e tagliare un modello passo passo, in una finestra vuota</translation>
    </message>
    <message>
        <source>Help on what is under the cursor</source>
        <translation>Aiuto su ciò che è sotto il cursore</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aiuto</translation>
    </message>
    <message>
        <source>Open the help where it tells about this part of the window</source>
        <translation>Apre l’aiuto dove parla di questa parte della finestra</translation>
    </message>
    <message>
        <source>Do not mirror</source>
        <translation>Non specchiare</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Leave everything as it was</source>
        <translation>Lascia tutto com’era</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Stampa JSON, per altri programmi.</translation>
    </message>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation>Sezioni, incastri, dimensioni e massa di un modello</translation>
    </message>
    <message>
        <source>Whether it holds together, stands, can be assembled and fits the sheet</source>
        <translation>Se resta insieme, sta in piedi, si può montare ed entra nella lastra</translation>
    </message>
    <message>
        <source>Whether it is strong enough: forces, stress and what it can hold</source>
        <translation>Se è abbastanza robusto: forze, tensioni e quanto può reggere</translation>
    </message>
    <message>
        <source>The parts to cut, in each section&apos;s own coordinates</source>
        <translation>I pezzi da tagliare, nelle coordinate proprie di ogni sezione</translation>
    </message>
    <message>
        <source>A picture of the model; needs a display</source>
        <translation>Un’immagine del modello; richiede uno schermo</translation>
    </message>
    <message>
        <source>How it goes together, step by step; needs a display</source>
        <translation>Come si monta, passo dopo passo; richiede uno schermo</translation>
    </message>
    <message>
        <source>The named values of a model, and what is made of them</source>
        <translation>I valori con nome di un modello, e che cosa ne dipende</translation>
    </message>
    <message>
        <source>A cutting file and a verdict for each line of a table of values</source>
        <translation>Un file di taglio e un esito per ogni riga di una tabella di valori</translation>
    </message>
    <message>
        <source>All kinds of operations, or the operations of a model</source>
        <translation>Tutti i tipi di operazioni, o le operazioni di un modello</translation>
    </message>
    <message>
        <source>The loops in which a plane cuts a mesh</source>
        <translation>Le curve chiuse in cui un piano taglia una mesh</translation>
    </message>
    <message>
        <source>Sections that show a mesh, stand and can be assembled</source>
        <translation>Sezioni che mostrano una mesh, stanno in piedi e si possono montare</translation>
    </message>
    <message>
        <source>A model of a mesh in slices</source>
        <translation>Un modello a fette di una mesh</translation>
    </message>
    <message>
        <source>A model of flat sheets with fingers along their edges</source>
        <translation>Un modello di lastre piane con denti lungo i bordi</translation>
    </message>
    <message>
        <source>Parts close together on sheets, or the items of a strip (.json)</source>
        <translation>Pezzi vicini tra loro sulle lastre, o gli elementi di una striscia (.json)</translation>
    </message>
    <message>
        <source>Plays a script of what a person does in the window</source>
        <translation>Riproduce uno script di ciò che una persona fa nella finestra</translation>
    </message>
    <message>
        <source>Cut away completely by slits, so there is no part: %1</source>
        <translation>Tagliate via del tutto dalle fessure, quindi senza pezzo: %1</translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation>Troppo grandi per la lastra, su lastre a parte: %1</translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation>Troppo sottili per portare un numero: %1</translation>
    </message>
    <message>
        <source>A hole or a notch narrower than the kerf is not cut: %1</source>
        <translation>Un foro o una tacca più stretti del solco di taglio non vengono tagliati: %1</translation>
    </message>
    <message>
        <source>No room for the numbers of all joints: %1</source>
        <translation>Non c’è spazio per i numeri di tutti gli incastri: %1</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>Impossibile scrivere sullo standard output.</translation>
    </message>
    <message>
        <source>Nothing to check: the model has no sections.</source>
        <translation>Nulla da controllare: il modello non ha sezioni.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n sezione</numerusform>
            <numerusform>%n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Sections bend where joints share a load, by finite elements; takes seconds.</source>
        <translation>Le sezioni si flettono dove più incastri si dividono un carico, con elementi finiti; richiede qualche secondo.</translation>
    </message>
    <message>
        <source>The load stays for months: each stock keeps only its share of strength for that.</source>
        <translation>Il carico resta per mesi: ogni materiale conserva solo la parte di resistenza prevista per questo.</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation>“%1” non esiste.</translation>
    </message>
    <message>
        <source>DXF with layers by purpose</source>
        <translation>DXF con livelli secondo lo scopo</translation>
    </message>
    <message>
        <source>Version of a DXF file: r2000 or r12 (r2000).</source>
        <translation>Versione di un file DXF: r2000 o r12 (r2000).</translation>
    </message>
    <message>
        <source>the model itself</source>
        <translation>il modello stesso</translation>
    </message>
    <message>
        <source>Millimetres per unit of a FlatFab file (25.4).</source>
        <translation>Millimetri per unità di un file FlatFab (25.4).</translation>
    </message>
    <message>
        <source>G-code for lasers</source>
        <translation>G-code per laser</translation>
    </message>
    <message>
        <source>a LightBurn project</source>
        <translation>un progetto LightBurn</translation>
    </message>
    <message>
        <source>the solids in place</source>
        <translation>i solidi al loro posto</translation>
    </message>
    <message>
        <source>the list of parts</source>
        <translation>l’elenco dei pezzi</translation>
    </message>
    <message>
        <source>PDF in true size</source>
        <translation>PDF in scala reale</translation>
    </message>
    <message>
        <source>Pages of a PDF file: sheet, or tiles on a4 or letter (sheet).</source>
        <translation>Pagine di un file PDF: sheet, o suddiviso su a4 o letter (sheet).</translation>
    </message>
    <message>
        <source>a picture of the sheets</source>
        <translation>un’immagine delle lastre</translation>
    </message>
    <message>
        <source>How parts lie in an STL or 3MF file: in-place, or flat on their sheets (in-place).</source>
        <translation>Come stanno i pezzi in un file STL o 3MF: in-place, o flat, distesi sulle loro lastre (in-place).</translation>
    </message>
    <message>
        <source>the parts to print</source>
        <translation>i pezzi da stampare</translation>
    </message>
    <message>
        <source>cutting files, true to size</source>
        <translation>file di taglio, in scala reale</translation>
    </message>
    <message>
        <source>all for a workshop</source>
        <translation>tutto per un laboratorio</translation>
    </message>
    <message>
        <source>there is no display with OpenGL 3.3.</source>
        <translation>non c’è uno schermo con OpenGL 3.3.</translation>
    </message>
    <message>
        <source>The search was stopped before its end, since this machine is busy: another run may come to another layout.</source>
        <translation>La ricerca è stata fermata prima della fine perché questo computer è occupato: un’altra esecuzione può dare un’altra disposizione.</translation>
    </message>
</context>
<context>
    <name>Coupon</name>
    <message>
        <source>Slits to try</source>
        <translation>Fessure da provare</translation>
    </message>
    <message>
        <source>Strip to push in</source>
        <translation>Striscia da infilare</translation>
    </message>
    <message>
        <source>Slat to measure</source>
        <translation>Listello da misurare</translation>
    </message>
</context>
<context>
    <name>Cue</name>
    <message>
        <source>Too near the edge: the slit would hold nothing</source>
        <translation>Troppo vicina al bordo: la fessura non terrebbe nulla</translation>
    </message>
    <message>
        <source>Too near the edge: the slit would hold nothing. B: move it in</source>
        <translation>Troppo vicina al bordo: la fessura non terrebbe nulla. B: spostala in dentro</translation>
    </message>
    <message>
        <source>Moved in by %1. B: put it back</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Spostata in dentro di %1. B: rimettila dov’era</translation>
    </message>
    <message>
        <source>level</source>
        <translation>orizzontale</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>verticale</translation>
    </message>
    <message>
        <source>square to the edge</source>
        <translation>perpendicolare al bordo</translation>
    </message>
    <message>
        <source>parallel to the last one</source>
        <translation>parallela all’ultima</translation>
    </message>
    <message>
        <source>Turning…</source>
        <translation>Rotazione…</translation>
    </message>
    <message>
        <source>Draw the outline</source>
        <translation>Disegna il contorno</translation>
    </message>
    <message>
        <source>Not joined yet</source>
        <extracomment>beside the cursor, while a contour does not reach its slit</extracomment>
        <translation>Non ancora collegata</translation>
    </message>
</context>
<context>
    <name>Driven</name>
    <message>
        <source>“%1” is %2, which is not possible here.</source>
        <extracomment>%1: an expression, %2 what it comes to</extracomment>
        <translation>“%1” vale %2, e qui non è possibile.</translation>
    </message>
    <message>
        <source>“%1” and another expression want this to be different at the same time.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>“%1” e un’altra espressione vogliono per questo numero valori diversi nello stesso momento.</translation>
    </message>
    <message>
        <source>What this number belongs to is not there any more.</source>
        <translation>Ciò a cui appartiene questo numero non c’è più.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Quota</translation>
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
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
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
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Testo</translation>
    </message>
    <message>
        <source>Height of letters</source>
        <translation>Altezza delle lettere</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Spessore</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Gioco</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>Solco di taglio</translation>
    </message>
    <message>
        <source>Width of a sheet</source>
        <translation>Larghezza di una lastra</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>Altezza di una lastra</translation>
    </message>
    <message>
        <source>Diameter of the tool</source>
        <translation>Diametro dell’utensile</translation>
    </message>
    <message>
        <source>Lead-in of slits</source>
        <translation>Invito delle fessure</translation>
    </message>
    <message>
        <source>Bumps in slits</source>
        <translation>Rilievi nelle fessure</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Filled with</source>
        <translation>Riempito con</translation>
    </message>
    <message>
        <source>Force along X</source>
        <translation>Forza lungo X</translation>
    </message>
    <message>
        <source>Force along Y</source>
        <translation>Forza lungo Y</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Forza trasversale</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>Punto d’incontro</translation>
    </message>
    <message>
        <source>“%1” is not possible here: numbers that follow values keep it at %2.</source>
        <extracomment>%1: what was typed, %2 a length or the like</extracomment>
        <translation>«%1» qui non è possibile: i numeri che seguono valori lo tengono a %2.</translation>
    </message>
    <message>
        <source>“%1” is not possible here: %2 follows “%3”, which keeps it as it is.</source>
        <extracomment>%1: what was typed, %2 names a number such as &quot;Wheel, Diameter&quot;, %3: an expression</extracomment>
        <translation>«%1» qui non è possibile: %2 segue «%3», che lo tiene com’è.</translation>
    </message>
    <message>
        <source>“%1” cannot be worked out.</source>
        <extracomment>%1 is the name of a value</extracomment>
        <translation>«%1» non si può calcolare.</translation>
    </message>
    <message>
        <source>“%1” is empty, which is not possible here.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>«%1» è vuoto, e qui non è possibile.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>there is not enough memory</source>
        <translation>la memoria non basta</translation>
    </message>
    <message>
        <source>a mesh: this is flat</source>
        <translation>una mesh: questa è piatta</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>byte</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>voci</translation>
    </message>
    <message>
        <source>its list of contents is damaged</source>
        <translation>il suo indice è danneggiato</translation>
    </message>
    <message>
        <source>this entry is damaged</source>
        <translation>questa voce è danneggiata</translation>
    </message>
    <message>
        <source>this entry is encrypted</source>
        <translation>questa voce è cifrata</translation>
    </message>
    <message>
        <source>there is more in this file than its contents</source>
        <translation>in questo file c’è più di ciò che elenca il suo indice</translation>
    </message>
    <message>
        <source>this entry occurs twice</source>
        <translation>questa voce compare due volte</translation>
    </message>
    <message>
        <source>this entry is packed in an unknown way</source>
        <translation>questa voce è compressa in un modo sconosciuto</translation>
    </message>
    <message>
        <source>this entry has another name than in the list of contents</source>
        <translation>questa voce ha un nome diverso da quello nell’indice</translation>
    </message>
    <message>
        <source>entries in it share their bytes</source>
        <translation>alcune sue voci condividono gli stessi byte</translation>
    </message>
    <message>
        <source>this entry unpacks to far too much</source>
        <translation>questa voce, decompressa, diventa troppo grande</translation>
    </message>
    <message>
        <source>undamaged gzip data</source>
        <translation>dati gzip integri</translation>
    </message>
    <message>
        <source>the rest of the gzip data</source>
        <translation>il resto dei dati gzip</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>una lastra più grande</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>un file ha bisogno di un nome</translation>
    </message>
    <message>
        <source>this file is read-only</source>
        <translation>questo file è di sola lettura</translation>
    </message>
    <message>
        <source>this folder is read-only</source>
        <translation>questa cartella è di sola lettura</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>un modello</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>è una cartella</translation>
    </message>
    <message>
        <source>this value is not allowed here</source>
        <translation>questo valore qui non è ammesso</translation>
    </message>
    <message>
        <source>found nothing, expected %1</source>
        <translation>non trovato nulla, atteso: %1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>trovato “%1”, atteso: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>this count is not possible</source>
        <translation>questa quantità non è possibile</translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation>trovato un numero di %1, atteso al massimo %2</translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation>trovati %1 %3, attesi al massimo %2 %3</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation>fatto con una versione più recente di FlatFitFab</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation>fatto con una versione più recente di FlatFitFab: trovato il formato %1, atteso al massimo %2</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour</source>
        <translation>questi punti di controllo non formano un contorno chiuso</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour: found %1, expected %2</source>
        <translation>questi punti di controllo non formano un contorno chiuso: trovato %1, atteso: %2</translation>
    </message>
    <message>
        <source>no path can follow this outline at half the kerf all the way round</source>
        <translation>nessun percorso può seguire tutto questo contorno a metà del solco di taglio</translation>
    </message>
    <message>
        <source>no path can follow %1 at half the kerf of %2 mm all the way round; smooth the finest details of its contour, or give its stock another kerf</source>
        <translation>nessun percorso può seguire tutto il contorno di %1 a metà del solco di taglio di %2 mm; smussa i dettagli più fini del contorno o dai al materiale un altro solco</translation>
    </message>
    <message>
        <source>the kerf closes a slit</source>
        <translation>il solco di taglio chiude una fessura</translation>
    </message>
    <message>
        <source>%1 has a slit %2 mm wide, which a kerf of %3 mm would close</source>
        <translation>%1 ha una fessura larga %2 mm, che un solco di taglio di %3 mm chiuderebbe</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>un file %1</translation>
    </message>
    <message>
        <source>a %1 file of %2</source>
        <translation>un file %1 di %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation>impossibile aprire il file</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>impossibile scrivere il file</translation>
    </message>
    <message>
        <source>not a model, expected %1</source>
        <translation>non è un modello, atteso: %1</translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation>il file finisce qui, atteso: %1</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>il file finisce troppo presto</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation>trovato “%1”, atteso: un numero finito</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>un numero non è finito</translation>
    </message>
    <message>
        <source>these axes do not form a frame, expected two of length 1 at a right angle</source>
        <translation>questi assi non formano un sistema di riferimento, attesi due di lunghezza 1 ad angolo retto</translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation>questo contorno non racchiude nessuna area</translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation>non c’è nulla con il numero %1</translation>
    </message>
    <message>
        <source>this refers to something that does not exist</source>
        <translation>questo rimanda a qualcosa che non esiste</translation>
    </message>
    <message>
        <source>the number %1 is used twice, expected one of its own</source>
        <translation>il numero %1 è usato due volte, atteso: un numero proprio</translation>
    </message>
    <message>
        <source>this number is used twice, expected one of its own</source>
        <translation>questo numero è usato due volte, atteso: un numero proprio</translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation>queste due sezioni sono quasi parallele e non si possono collegare</translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation>questo contorno incrocia sé stesso</translation>
    </message>
    <message>
        <source>a hole would touch the edge or another hole</source>
        <translation>un foro toccherebbe il bordo o un altro foro</translation>
    </message>
    <message>
        <source>too few points would be left to enclose anything</source>
        <translation>resterebbero troppo pochi punti per racchiudere qualcosa</translation>
    </message>
    <message>
        <source>slits leave nothing of any section, so there is nothing to cut</source>
        <translation>le fessure non lasciano nulla di nessuna sezione, quindi non c’è nulla da tagliare</translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation>non c’è ancora nessuna sezione, quindi non c’è nulla da tagliare</translation>
    </message>
    <message>
        <source>none of the places between its contours can be covered (%1), so there is no skin</source>
        <translation>nessuna delle zone tra i contorni si può coprire (%1), quindi non c’è pelle</translation>
    </message>
    <message>
        <source>no contours cross each other at their edges, so there is no skin</source>
        <translation>nessun contorno ne incrocia un altro al bordo, quindi non c’è pelle</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>non esiste il comando “%1”</translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation>questo comando non esiste</translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation>questo evento qui non ha senso</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation>“%1” non è supportato da questa versione</translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation>questo non è supportato da questa versione</translation>
    </message>
    <message>
        <source>this could not be worked out</source>
        <translation>non si è potuto calcolare</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be cut out: what its slits leave of it could not be worked out</source>
        <translation>impossibile ritagliare “%1”: non si è potuto calcolare che cosa ne lasciano le fessure</translation>
    </message>
    <message>
        <source>a section could not be cut out</source>
        <translation>impossibile ritagliare una sezione</translation>
    </message>
    <message>
        <source>the solid of &quot;%1&quot; could not be worked out</source>
        <translation>impossibile calcolare il solido di “%1”</translation>
    </message>
    <message>
        <source>a solid could not be worked out</source>
        <translation>impossibile calcolare un solido</translation>
    </message>
    <message>
        <source>the marks on &quot;%1&quot; could not be trimmed at its edge</source>
        <translation>impossibile tagliare al bordo i segni su “%1”</translation>
    </message>
    <message>
        <source>the marks on a section could not be trimmed at its edge</source>
        <translation>impossibile tagliare al bordo i segni su una sezione</translation>
    </message>
    <message>
        <source>the sections of the operation &quot;%1&quot; could not be worked out</source>
        <translation>impossibile calcolare le sezioni dell’operazione “%1”</translation>
    </message>
    <message>
        <source>the sections of an operation could not be worked out</source>
        <translation>impossibile calcolare le sezioni di un’operazione</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab (%1)</source>
        <translation>qualcosa è andato storto dentro FlatFitFab (%1)</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab</source>
        <translation>qualcosa è andato storto dentro FlatFitFab</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>è stato fermato</translation>
    </message>
    <message>
        <source>the contents of this file are damaged</source>
        <translation>il contenuto di questo file è danneggiato</translation>
    </message>
    <message>
        <source>%1 was slightly skewed and has been straightened</source>
        <translation>%1 era leggermente storta ed è stata raddrizzata</translation>
    </message>
    <message>
        <source>a section was slightly skewed and has been straightened</source>
        <translation>una sezione era leggermente storta ed è stata raddrizzata</translation>
    </message>
    <message>
        <source>the contour of %1 crosses itself; its largest loop was kept</source>
        <translation>il contorno di %1 incrocia sé stesso; è rimasto l’anello più grande</translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest loop was kept</source>
        <translation>un contorno incrocia sé stesso; è rimasto l’anello più grande</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was left out</source>
        <translation>un foro di %1 esce dal contorno ed è stato omesso</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was left out</source>
        <translation>un foro esce dal contorno ed è stato omesso</translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation>un foro di %1 non ha area ed è stato omesso</translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation>un foro non ha area ed è stato omesso</translation>
    </message>
    <message>
        <source>holes of %1 overlap and were merged into one</source>
        <translation>i fori di %1 si sovrappongono e sono stati uniti in uno</translation>
    </message>
    <message>
        <source>holes overlap and were merged into one</source>
        <translation>alcuni fori si sovrappongono e sono stati uniti in uno</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was cut out of it</source>
        <translation>un foro di %1 esce dal contorno e ne è stato ritagliato</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was cut out of it</source>
        <translation>un foro esce dal contorno e ne è stato ritagliato</translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation>le righe dopo l’ultima sezione sono state ignorate</translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation>il testo dopo l’ultima sezione è stato ignorato, righe: %1</translation>
    </message>
    <message>
        <source>%1 could not be read and was left out</source>
        <translation>impossibile leggere %1: è stato omesso</translation>
    </message>
    <message>
        <source>a picture or a mesh was left out</source>
        <translation>un’immagine o una mesh è stata omessa</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <extracomment>%2 is a reason such as &quot;its data is missing&quot;</extracomment>
        <translation>%1 è stato omesso: %2</translation>
    </message>
    <message>
        <source>what %1 shows could not be read; its place was kept</source>
        <translation>impossibile leggere ciò che mostra %1; il suo posto è stato conservato</translation>
    </message>
    <message>
        <source>a template could not be read; its place was kept</source>
        <translation>impossibile leggere un riferimento; il suo posto è stato conservato</translation>
    </message>
    <message>
        <source>engraved or scored</source>
        <translation>engraved o scored</translation>
    </message>
    <message>
        <source>three control points per segment and one more</source>
        <translation>tre punti di controllo per segmento e uno in più</translation>
    </message>
    <message>
        <source>at least one line</source>
        <translation>almeno una linea</translation>
    </message>
    <message>
        <source>two different places</source>
        <translation>due punti diversi</translation>
    </message>
    <message>
        <source>a word of letters and digits, once</source>
        <translation>una parola di lettere e cifre, una sola volta</translation>
    </message>
    <message>
        <source>its data is missing</source>
        <translation>mancano i suoi dati</translation>
    </message>
    <message>
        <source>a SHA-256 in 64 hexadecimal digits</source>
        <translation>uno SHA-256 di 64 cifre esadecimali</translation>
    </message>
    <message>
        <source>an entry with this name does not belong here</source>
        <translation>qui non deve esserci una voce con questo nome</translation>
    </message>
    <message>
        <source>the data of this entry does not match its name, a SHA-256</source>
        <translation>i dati di questa voce non corrispondono al suo nome, uno SHA-256</translation>
    </message>
    <message>
        <source>this entry is missing</source>
        <translation>questa voce manca</translation>
    </message>
    <message>
        <source>nothing in the document refers to this entry</source>
        <translation>nulla nel documento rimanda a questa voce</translation>
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
        <translation>una larghezza da 1 a 10000 mm</translation>
    </message>
    <message>
        <source>a force [x, y, z] above 0, at most 1000000 N</source>
        <translation>una forza [x, y, z] superiore a 0, al massimo 1000000 N</translation>
    </message>
    <message>
        <source>a height from 0 to 10000 mm</source>
        <translation>un’altezza da 0 a 10000 mm</translation>
    </message>
    <message>
        <source>a part of its mass</source>
        <translation>una parte della sua massa</translation>
    </message>
    <message>
        <source>hidden or detached</source>
        <translation>hidden o detached</translation>
    </message>
    <message>
        <source>something other than made, each instance once</source>
        <translation>uno stato diverso da made, ogni istanza una sola volta</translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation>un id inferiore a nextId</translation>
    </message>
    <message>
        <source>a share above 0, 1 at most</source>
        <translation>una frazione superiore a 0, al massimo 1</translation>
    </message>
    <message>
        <source>more than minus the thickness</source>
        <translation>più dello spessore in negativo</translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation>una larghezza e un’altezza superiori a 0</translation>
    </message>
    <message>
        <source>square, round, dogbone or tBone</source>
        <translation>square, round, dogbone o tBone</translation>
    </message>
    <message>
        <source>three control points per segment, at least 6</source>
        <translation>tre punti di controllo per segmento, almeno 6</translation>
    </message>
    <message>
        <source>proportion, left, right, bottom or top</source>
        <translation>proportion, left, right, bottom o top</translation>
    </message>
    <message>
        <source>a direction of length 1</source>
        <translation>una direzione di lunghezza 1</translation>
    </message>
    <message>
        <source>crossLap, mortise, tabs or none</source>
        <translation>crossLap, mortise, tabs o none</translation>
    </message>
    <message>
        <source>a share from 0.05 to 0.95</source>
        <translation>una frazione da 0.05 a 0.95</translation>
    </message>
    <message>
        <source>something wanted of two sections, pairs ascending</source>
        <translation>una richiesta per due sezioni, con le coppie in ordine crescente</translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation>una sezione madre che non discenda dalla propria figlia</translation>
    </message>
    <message>
        <source>at least one stock</source>
        <translation>almeno un materiale</translation>
    </message>
    <message>
        <source>each part once, in the order of sections</source>
        <translation>ogni pezzo una volta, nell’ordine delle sezioni</translation>
    </message>
    <message>
        <source>each section once, in their order</source>
        <translation>ogni sezione una volta, nel loro ordine</translation>
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
        <translation>nulla: solo le mesh si possono attrarre</translation>
    </message>
    <message>
        <source>a radius from 0.1 to 1000 mm</source>
        <translation>un raggio da 0.1 a 1000 mm</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>il percorso di un file</translation>
    </message>
    <message>
        <source>a blob&apos;s SHA-256, or a file</source>
        <translation>lo SHA-256 di un blob, o un file</translation>
    </message>
    <message>
        <source>nothing: a mesh lies on no section</source>
        <translation>nulla: una mesh non giace su nessuna sezione</translation>
    </message>
    <message>
        <source>a scale from 1e-9 to 1e9</source>
        <translation>una scala da 1e-9 a 1e9</translation>
    </message>
    <message>
        <source>an opacity from 0 to 1</source>
        <translation>un’opacità da 0 a 1</translation>
    </message>
    <message>
        <source>decimals or groups</source>
        <translation>decimals o groups</translation>
    </message>
    <message>
        <source>an expression that is not that long</source>
        <translation>un’espressione meno lunga</translation>
    </message>
    <message>
        <source>number, length, angle, count, mass, ratio, text, choice or switch</source>
        <translation>number, length, angle, count, mass, ratio, text, choice o switch</translation>
    </message>
    <message>
        <source>a name without “=”, each once</source>
        <translation>un nome senza “=”, ognuno una sola volta</translation>
    </message>
    <message>
        <source>each value once</source>
        <translation>ogni valore una sola volta</translation>
    </message>
    <message>
        <source>a word of letters and digits, each once</source>
        <translation>una parola di lettere e cifre, ognuna una sola volta</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>ogni numero una sola volta</translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation>una lunghezza di al massimo 1000000 mm</translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation>un ultimo punto di controllo che ripeta il primo</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un numero</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>una quantità</translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation>un punto di due numeri</translation>
    </message>
    <message>
        <source>three control points per segment and the first again, at least 7</source>
        <translation>tre punti di controllo per segmento e di nuovo il primo, almeno 7</translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation>almeno 1 curva</translation>
    </message>
    <message>
        <source>a buffer with bytes</source>
        <translation>un buffer con byte</translation>
    </message>
    <message>
        <source>a buffer in the file</source>
        <translation>un buffer nel file</translation>
    </message>
    <message>
        <source>a length that its buffer has</source>
        <translation>una lunghezza contenuta nel suo buffer</translation>
    </message>
    <message>
        <source>a type of numbers that glTF has</source>
        <translation>un tipo di numeri previsto da glTF</translation>
    </message>
    <message>
        <source>as many values as its buffer has</source>
        <translation>tanti valori quanti ne ha il suo buffer</translation>
    </message>
    <message>
        <source>as many numbers as belong there</source>
        <translation>la giusta quantità di numeri</translation>
    </message>
    <message>
        <source>a node that is not within itself</source>
        <translation>un nodo che non sia dentro sé stesso</translation>
    </message>
    <message>
        <source>a chunk of a GLB file</source>
        <translation>un blocco di un file GLB</translation>
    </message>
    <message>
        <source>version 2 of GLB</source>
        <translation>la versione 2 di GLB</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>un file glTF</translation>
    </message>
    <message>
        <source>version 2 of glTF</source>
        <translation>la versione 2 di glTF</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un oggetto</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>un elenco</translation>
    </message>
    <message>
        <source>a number above 0, at most 1000000</source>
        <translation>un numero superiore a 0, al massimo 1000000</translation>
    </message>
    <message>
        <source>a number from 0 to 1000000</source>
        <translation>un numero da 0 a 1000000</translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation>un numero intero nel suo intervallo</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un testo</translation>
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
        <translation>un elenco di punti</translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation>un nome tra virgolette o la fine dell’oggetto</translation>
    </message>
    <message>
        <source>a colon</source>
        <translation>due punti</translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation>una virgola o la fine dell’elenco</translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation>una sequenza di escape JSON</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>testo in UTF-8</translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation>la fine del testo tra virgolette</translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation>un altro valore dopo la virgola</translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation>non più di 1024 livelli</translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation>un file più piccolo</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>la fine del file</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>un valore</translation>
    </message>
    <message>
        <source>each key of an object only once</source>
        <translation>ogni chiave di un oggetto una sola volta</translation>
    </message>
    <message>
        <source>both halves of a character</source>
        <translation>tutte e due le metà di un carattere</translation>
    </message>
    <message>
        <source>a colour such as #ff0000</source>
        <translation>un colore come #ff0000</translation>
    </message>
    <message>
        <source>a width of lines in mm</source>
        <translation>uno spessore delle linee in mm</translation>
    </message>
    <message>
        <source>a speed in mm/s</source>
        <translation>una velocità in mm/s</translation>
    </message>
    <message>
        <source>a line of G-code</source>
        <translation>una riga di G-code</translation>
    </message>
    <message>
        <source>lines of G-code</source>
        <translation>righe di G-code</translation>
    </message>
    <message>
        <source>the largest S</source>
        <translation>il valore massimo di S</translation>
    </message>
    <message>
        <source>width and height in mm</source>
        <translation>larghezza e altezza in mm</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>una frazione da 0 a 1</translation>
    </message>
    <message>
        <source>a width of tabs in mm</source>
        <translation>una larghezza dei ponticelli in mm</translation>
    </message>
    <message>
        <source>a length of leads in mm</source>
        <translation>una lunghezza degli attacchi in mm</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>macchine</translation>
    </message>
    <message>
        <source>a machine</source>
        <translation>una macchina</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triangoli</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>vertici</translation>
    </message>
    <message>
        <source>it is in another folder</source>
        <translation>è in un’altra cartella</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>una mesh</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un numero intero</translation>
    </message>
    <message>
        <source>at least three points</source>
        <translation>almeno tre punti</translation>
    </message>
    <message>
        <source>simple_polygon or polygon</source>
        <translation>simple_polygon o polygon</translation>
    </message>
    <message>
        <source>at least one angle</source>
        <translation>almeno un angolo</translation>
    </message>
    <message>
        <source>an instance of strip packing</source>
        <translation>un problema di disposizione su striscia</translation>
    </message>
    <message>
        <source>at least one item</source>
        <translation>almeno un elemento</translation>
    </message>
    <message>
        <source>at least three corners of a face</source>
        <translation>almeno tre vertici di una faccia</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>il numero di vertici</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>il numero di facce</translation>
    </message>
    <message>
        <source>the corners of a face</source>
        <translation>i vertici di una faccia</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixel</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>l’immagine è danneggiata</translation>
    </message>
    <message>
        <source>the rest of the picture</source>
        <translation>il resto dell’immagine</translation>
    </message>
    <message>
        <source>the picture is damaged here</source>
        <translation>l’immagine è danneggiata qui</translation>
    </message>
    <message>
        <source>a picture as PNG, JPEG or WebP</source>
        <translation>un’immagine PNG, JPEG o WebP</translation>
    </message>
    <message>
        <source>a picture with at least one pixel</source>
        <translation>un’immagine con almeno un pixel</translation>
    </message>
    <message>
        <source>nothing is writing to this pipe</source>
        <translation>nessuno scrive in questa pipe</translation>
    </message>
    <message>
        <source>nothing came out of it for 10 seconds</source>
        <translation>non ha dato alcun risultato per 10 secondi</translation>
    </message>
    <message>
        <source>nothing is reading from this pipe</source>
        <translation>nessuno legge da questa pipe</translation>
    </message>
    <message>
        <source>the format</source>
        <translation>il formato</translation>
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
        <translation>un tipo come float o int</translation>
    </message>
    <message>
        <source>an element first</source>
        <translation>prima un elemento</translation>
    </message>
    <message>
        <source>as many values as the file says it has</source>
        <translation>tanti valori quanti ne dichiara il file</translation>
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
        <translation>la lunghezza di un elenco</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>il disco è pieno</translation>
    </message>
    <message>
        <source>the number of triangles</source>
        <translation>il numero di triangoli</translation>
    </message>
    <message>
        <source>as many triangles as the file says it has</source>
        <translation>tanti triangoli quanti ne dichiara il file</translation>
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
        <translation>tre vertici di un triangolo</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>lines; text must be turned into paths first</source>
        <translation>linee; il testo va prima convertito in tracciati</translation>
    </message>
    <message>
        <source>lines; a picture must be traced first</source>
        <translation>linee; un’immagine va prima ricalcata</translation>
    </message>
    <message>
        <source>lines, shapes or paths</source>
        <translation>linee, forme o tracciati</translation>
    </message>
    <message>
        <source>a transform</source>
        <translation>una trasformazione</translation>
    </message>
    <message>
        <source>groups in groups</source>
        <translation>gruppi dentro gruppi</translation>
    </message>
    <message>
        <source>places within a kilometre</source>
        <translation>punti entro un chilometro</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>coppie di numeri</translation>
    </message>
    <message>
        <source>path data</source>
        <translation>dati di tracciato</translation>
    </message>
    <message>
        <source>elements and attributes</source>
        <translation>elementi e attributi</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>un disegno SVG</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>una lunghezza</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punti</translation>
    </message>
    <message>
        <source>a picture or a drawing</source>
        <translation>un’immagine o un disegno</translation>
    </message>
    <message>
        <source>there is no 3D model in this file</source>
        <translation>in questo file non c’è nessun modello 3D</translation>
    </message>
    <message>
        <source>a 3D model</source>
        <translation>un modello 3D</translation>
    </message>
    <message>
        <source>a unit such as millimeter</source>
        <translation>un’unità come millimeter</translation>
    </message>
    <message>
        <source>twelve numbers</source>
        <translation>dodici numeri</translation>
    </message>
    <message>
        <source>an object that does not contain itself</source>
        <translation>un oggetto che non contenga sé stesso</translation>
    </message>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>%n sezione era leggermente storta ed è stata raddrizzata.</numerusform>
            <numerusform>%n sezioni erano leggermente storte e sono state raddrizzate.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>%n contorno incrociava sé stesso; è rimasto l’anello più grande.</numerusform>
            <numerusform>%n contorni incrociavano sé stessi; di ciascuno è rimasto l’anello più grande.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>%n foro usciva dal contorno ed è stato omesso.</numerusform>
            <numerusform>%n fori uscivano dal contorno e sono stati omessi.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>%n foro non aveva area ed è stato omesso.</numerusform>
            <numerusform>%n fori non avevano area e sono stati omessi.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>I fori di %n sezione si sovrapponevano e sono stati uniti.</numerusform>
            <numerusform>I fori di %n sezioni si sovrapponevano e sono stati uniti.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>%n foro usciva dal contorno e ne è stato ritagliato.</numerusform>
            <numerusform>%n fori uscivano dai contorni e ne sono stati ritagliati.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>Il testo dopo l’ultima sezione è stato ignorato in %n punto.</numerusform>
            <numerusform>Il testo dopo l’ultima sezione è stato ignorato in %n punti.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>Non si è potuta leggere %n immagine o mesh, che è stata omessa.</numerusform>
            <numerusform>Non si sono potute leggere %n immagini o mesh, che sono state omesse.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>Non si è potuto leggere %n riferimento; il suo posto è stato conservato.</numerusform>
            <numerusform>Non si sono potuti leggere %n riferimenti; i loro posti sono stati conservati.</numerusform>
        </translation>
    </message>
    <message>
        <source>the folder cannot be used</source>
        <translation>la cartella non si può usare</translation>
    </message>
    <message>
        <source>it is open in another window</source>
        <translation>è aperto in un’altra finestra</translation>
    </message>
    <message>
        <source>places where a line may cross itself</source>
        <translation>punti in cui una linea può incrociare sé stessa</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>i suoi dati sono danneggiati</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>una mesh con almeno un triangolo</translation>
    </message>
    <message>
        <source>an edge with three faces or more</source>
        <translation>uno spigolo con tre facce o più</translation>
    </message>
    <message>
        <source>a mesh of which two faces meet at an edge</source>
        <translation>una mesh in cui due facce si incontrino in uno spigolo</translation>
    </message>
    <message>
        <source>what was to follow “%1” is a plain number now</source>
        <extracomment>%1 is an expression</extracomment>
        <translation>ciò che doveva seguire «%1» ora è un semplice numero</translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n numero non segue più ciò che era stato scritto.</numerusform>
            <numerusform>%n numeri non seguono più ciò che era stato scritto.</numerusform>
        </translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>un’immagine</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>un disegno</translation>
    </message>
    <message>
        <source>each machine once, in their order</source>
        <translation>ogni macchina una volta, nel loro ordine</translation>
    </message>
    <message>
        <source>offcuts</source>
        <translation>ritagli</translation>
    </message>
    <message>
        <source>an outline from 0, 0 on that does not cross itself</source>
        <translation>una sagoma da 0, 0 che non si incroci</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>spessori</translation>
    </message>
    <message>
        <source>what a sheet can have</source>
        <translation>ciò che una lastra può avere</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>materiali</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart</source>
        <translation>la sagoma è aperta: i suoi estremi distano %1 mm</translation>
    </message>
    <message>
        <source>coordinates up to 1e12</source>
        <translation>coordinate fino a 1e12</translation>
    </message>
    <message>
        <source>placed objects</source>
        <translation>oggetti posizionati</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Circle</source>
        <translation>Cerchio</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diametro</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellisse</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rettangolo</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Raggio angoli</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Poligono</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Lati</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stella</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>Diametro interno</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>Punte</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Asola</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Cannot be made</source>
        <translation>Non si può fare</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>DXF, true to size</source>
        <translation>DXF, in scala reale</translation>
    </message>
    <message>
        <source>DXF, one for each sheet</source>
        <translation>DXF, uno per lastra</translation>
    </message>
    <message>
        <source>DXF for old programs, R12</source>
        <translation>DXF per vecchi programmi, R12</translation>
    </message>
    <message>
        <source>FlatFitFab models</source>
        <translation>Modelli FlatFitFab</translation>
    </message>
    <message>
        <source>G-code for GRBL lasers</source>
        <translation>G-code per laser GRBL</translation>
    </message>
    <message>
        <source>G-code, one for each sheet</source>
        <translation>G-code, uno per lastra</translation>
    </message>
    <message>
        <source>glTF meshes</source>
        <translation>Mesh glTF</translation>
    </message>
    <message>
        <source>LightBurn project</source>
        <translation>Progetto LightBurn</translation>
    </message>
    <message>
        <source>LightBurn, one for each sheet</source>
        <translation>LightBurn, uno per lastra</translation>
    </message>
    <message>
        <source>OBJ meshes</source>
        <translation>Mesh OBJ</translation>
    </message>
    <message>
        <source>OBJ, solids in place</source>
        <translation>OBJ, solidi al loro posto</translation>
    </message>
    <message>
        <source>OBJ, skin as a mesh</source>
        <translation>OBJ, pelle come mesh</translation>
    </message>
    <message>
        <source>OFF meshes</source>
        <translation>Mesh OFF</translation>
    </message>
    <message>
        <source>Parts list for spreadsheets</source>
        <translation>Elenco pezzi per fogli di calcolo</translation>
    </message>
    <message>
        <source>PDF, a page for each sheet</source>
        <translation>PDF, una pagina per lastra</translation>
    </message>
    <message>
        <source>PDF, tiled on A4</source>
        <translation>PDF, suddiviso su A4</translation>
    </message>
    <message>
        <source>PDF, tiled on Letter</source>
        <translation>PDF, suddiviso su Letter</translation>
    </message>
    <message>
        <source>PLY meshes</source>
        <translation>Mesh PLY</translation>
    </message>
    <message>
        <source>Picture of the sheets</source>
        <translation>Immagine delle lastre</translation>
    </message>
    <message>
        <source>Pictures, one for each sheet</source>
        <translation>Immagini, una per lastra</translation>
    </message>
    <message>
        <source>STL meshes</source>
        <translation>Mesh STL</translation>
    </message>
    <message>
        <source>STL, solids in place</source>
        <translation>STL, solidi al loro posto</translation>
    </message>
    <message>
        <source>STL, skin as a mesh</source>
        <translation>STL, pelle come mesh</translation>
    </message>
    <message>
        <source>STL, solids lying flat</source>
        <translation>STL, solidi distesi</translation>
    </message>
    <message>
        <source>SVG, true to size</source>
        <translation>SVG, in scala reale</translation>
    </message>
    <message>
        <source>SVG, one for each sheet</source>
        <translation>SVG, uno per lastra</translation>
    </message>
    <message>
        <source>3MF meshes</source>
        <translation>Mesh 3MF</translation>
    </message>
    <message>
        <source>3MF, solids in place</source>
        <translation>3MF, solidi al loro posto</translation>
    </message>
    <message>
        <source>3MF, solids lying flat</source>
        <translation>3MF, solidi distesi</translation>
    </message>
    <message>
        <source>All for the workshop, packed</source>
        <translation>Tutto per il laboratorio, in un archivio</translation>
    </message>
    <message>
        <source>All for the workshop, in a folder</source>
        <translation>Tutto per il laboratorio, in una cartella</translation>
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
        <translation>&lt;kbd&gt;%1&lt;/kbd&gt; lo annulla.</translation>
    </message>
    <message>
        <source>Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.</source>
        <translation>Nulla di spostato: dove %1 e %2 si incontrano non ci sono due fessure che si dividono la profondità.</translation>
    </message>
    <message>
        <source>Nothing changed: %1 and %2 cannot be joined like that.</source>
        <translation>Nulla è cambiato: %1 e %2 non si possono collegare così.</translation>
    </message>
    <message>
        <source>Nothing flipped: the slits of %1 and %2 cannot open to the other side.</source>
        <translation>Nulla di invertito: le fessure di %1 e %2 non possono aprirsi dall’altra parte.</translation>
    </message>
    <message>
        <source>Nothing trimmed: %1 is not in %2, or nothing of it would remain.</source>
        <translation>Nulla di accorciato: %1 non è dentro %2, o non ne resterebbe nulla.</translation>
    </message>
    <message>
        <source>Move to shift the cut, release to leave it there. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Muovi per spostare il piano di taglio, rilascia per lasciarlo lì. &lt;kbd&gt;Esc&lt;/kbd&gt; lo rimette dov’era.</translation>
    </message>
    <message>
        <source>You can&apos;t draw on a plane seen edge-on: turn the view to go on.</source>
        <translation>Non si può disegnare su un piano visto di taglio: ruota la vista per continuare.</translation>
    </message>
    <message>
        <source>Path discarded: its section no longer exists.</source>
        <translation>Tracciato scartato: la sua sezione non esiste più.</translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made from this line. Draw it as one open loop.</source>
        <translation>Nulla di disegnato: da questa linea non si può fare una sezione. Disegnala come un solo anello aperto.</translation>
    </message>
    <message>
        <source>Nothing drawn: all of it lies below the ground, where it is cut off.</source>
        <translation>Nulla di disegnato: sta tutto sotto il suolo, dove viene tagliato via.</translation>
    </message>
    <message>
        <source>No hole made: it must lie in %1 and leave it in one piece.</source>
        <translation>Nessun foro: deve stare dentro %1 e lasciarla intera.</translation>
    </message>
    <message>
        <source>The hole reaches beyond the edge of %1 and was cut out of it.</source>
        <translation>Il foro esce dal bordo di %1 e ne è stato ritagliato.</translation>
    </message>
    <message>
        <source>The hole touched others in %1; they are one hole now.</source>
        <translation>Il foro ne toccava altri in %1; ora sono un foro solo.</translation>
    </message>
    <message>
        <source>Holes of %1 outside its new contour were left out.</source>
        <translation>I fori di %1 fuori dal nuovo contorno sono stati omessi.</translation>
    </message>
    <message>
        <source>Draw a section on the ground in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Disegna una sezione sul suolo in un solo tratto. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Draw a section on the front plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Disegna una sezione sul piano frontale in un solo tratto. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Draw a section on the side plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Disegna una sezione sul piano laterale in un solo tratto. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Draw a section parallel to %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Disegna una sezione parallela a %1 in un solo tratto. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Draw the new contour of %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>Disegna il nuovo contorno di %1 in un solo tratto. &lt;kbd&gt;Esc&lt;/kbd&gt; lascia quello vecchio.</translation>
    </message>
    <message>
        <source>Draw a hole in %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Disegna un foro in %1 in un solo tratto. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Draw a hole: begin on the section that gets it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Disegna un foro: comincia sulla sezione che lo riceve. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Nothing imported: no line in %1 forms a closed outline. They can be engraved.</source>
        <translation>Nulla di importato: nessuna linea in %1 forma una sagoma chiusa. Si possono incidere.</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%n sagoma di %1 non andava bene ed è stata omessa.</numerusform>
            <numerusform>%n sagome di %1 non andavano bene e sono state omesse.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 skipped; %3.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %3, tralasciando %2.</translation>
    </message>
    <message>
        <source>%1: %2 and %3 skipped; %4.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;1 picture&quot;, %4 &quot;5 lines were read&quot;</extracomment>
        <translation>%1: %4, tralasciando %2 e %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts</source>
        <translation>
            <numerusform>%n testo</numerusform>
            <numerusform>%n testi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures</source>
        <translation>
            <numerusform>%n immagine</numerusform>
            <numerusform>%n immagini</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>letta %n linea</numerusform>
            <numerusform>lette %n linee</numerusform>
        </translation>
    </message>
    <message>
        <source>%2 lies aslant to %1: move it to the plane of %1 first.</source>
        <extracomment>%1 is a section, %2 the name of a template</extracomment>
        <translation>%2 è obliquo rispetto a %1: spostalo prima sul piano di %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 ha %n sagoma, troppe: ricalca in modo meno fine o liscia prima.</numerusform>
            <numerusform>%1 ha %n sagome, troppe: ricalca in modo meno fine o liscia prima.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing traced: no part of %1 is on that side of the threshold.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Nulla di ricalcato: nessuna parte di %1 sta da quel lato della soglia.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre; a click makes one of the usual size.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;)</extracomment>
        <translation>%1: trascina dal centro verso l’esterno; un clic usa la misura solita.</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre to cut it out of %2.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;), %2 the name of a section</extracomment>
        <translation>%1: trascina dal centro verso l’esterno per ritagliarlo da %2.</translation>
    </message>
    <message>
        <source>Release to make it this size; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps both sides equal. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rilascia per farlo di questa misura; &lt;kbd&gt;Maiusc&lt;/kbd&gt; tiene uguali i due lati. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation>Disegna la prima sezione: premi, traccia la forma in un solo tratto, rilascia.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Shift&lt;/kbd&gt; drag selects a group.</source>
        <translation>Trascina per ruotare la vista; trascina con &lt;kbd&gt;Maiusc&lt;/kbd&gt; per selezionare un gruppo.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation>Trascina fuori da %1 per disegnare una sezione di traverso; fai clic per selezionarla.</translation>
    </message>
    <message>
        <source>Click to select %1. Drag to turn the view: you can&apos;t draw on a section seen edge-on.</source>
        <translation>Fai clic per selezionare %1. Trascina per ruotare la vista: non si può disegnare su una sezione vista di taglio.</translation>
    </message>
    <message>
        <source>Drag to move the cut through the model; &lt;kbd&gt;Esc&lt;/kbd&gt; closes it.</source>
        <translation>Trascina per spostare il piano di taglio nel modello; &lt;kbd&gt;Esc&lt;/kbd&gt; lo chiude.</translation>
    </message>
    <message>
        <source>Click to select problem %1.</source>
        <translation>Fai clic per selezionare il problema %1.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, arrow keys move 1&#x202f;mm.</source>
        <translation>Trascina per spostare il punto; &lt;kbd&gt;Ctrl&lt;/kbd&gt; fa un angolo, le frecce spostano di 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to bend the curve; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Trascina per piegare la curva; &lt;kbd&gt;Ctrl&lt;/kbd&gt; fa un angolo, &lt;kbd&gt;Maiusc&lt;/kbd&gt; mantiene la direzione.</translation>
    </message>
    <message>
        <source>Double-click to add a point here; drag to bend the contour.</source>
        <translation>Fai doppio clic per aggiungere qui un punto; trascina per curvare il contorno.</translation>
    </message>
    <message>
        <source>Click to select the joint of %1 and %2.</source>
        <translation>Fai clic per selezionare l’incastro di %1 e %2.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.</source>
        <translation>Trascina per rendere più profonda la fessura di %1 e meno quella di %2; fai clic per selezionare l’incastro.</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1&#x202f;mm.</source>
        <translation>Trascina per rendere più profonda la fessura di %1 e meno quella di %2; le frecce spostano di 1&#x202f;mm.</translation>
    </message>
    <message>
        <source>Drag to move the weight of %1 on %2; click to select it.</source>
        <translation>Trascina per spostare il peso di %1 su %2; fai clic per selezionarlo.</translation>
    </message>
    <message>
        <source>Arrow keys move the weight of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Le frecce spostano il peso di %1 su %2 di 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; e &lt;kbd&gt;−&lt;/kbd&gt; lo cambiano, &lt;kbd&gt;Canc&lt;/kbd&gt; lo rimuove.</translation>
    </message>
    <message>
        <source>Drag to move the push of %1 on %2, its tip to turn it; click to select it.</source>
        <translation>Trascina per spostare la spinta di %1 su %2, la punta per ruotarla; fai clic per selezionarla.</translation>
    </message>
    <message>
        <source>Arrow keys move the push of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>Le frecce spostano la spinta di %1 su %2 di 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; e &lt;kbd&gt;−&lt;/kbd&gt; la cambiano, &lt;kbd&gt;Canc&lt;/kbd&gt; la rimuove.</translation>
    </message>
    <message>
        <source>%1 is made by %2: click to edit them all, click again for this one.</source>
        <translation>%1 è creata da %2: fai clic per modificarle tutte, un altro clic per questa sola.</translation>
    </message>
    <message>
        <source>Click to select %1 alone; drag out of it to draw a section across it.</source>
        <translation>Fai clic per selezionare solo %1; trascina fuori per disegnare una sezione di traverso.</translation>
    </message>
    <message>
        <source>Drag a round handle to move the start or the end of %1; click one section to select it.</source>
        <translation>Trascina una maniglia rotonda per spostare l’inizio o la fine di %1; fai clic su una sezione per selezionarla.</translation>
    </message>
    <message>
        <source>Drag to move the start of %1; click to type it.</source>
        <translation>Trascina per spostare l’inizio di %1; fai clic per scriverlo.</translation>
    </message>
    <message>
        <source>Drag to move the end of %1; click to type it.</source>
        <translation>Trascina per spostare la fine di %1; fai clic per scriverla.</translation>
    </message>
    <message>
        <source>Click to look from the front; drag to turn the view.</source>
        <translation>Fai clic per guardare di fronte; trascina per ruotare la vista.</translation>
    </message>
    <message>
        <source>Click to look from the back; drag to turn the view.</source>
        <translation>Fai clic per guardare da dietro; trascina per ruotare la vista.</translation>
    </message>
    <message>
        <source>Click to look from the left; drag to turn the view.</source>
        <translation>Fai clic per guardare da sinistra; trascina per ruotare la vista.</translation>
    </message>
    <message>
        <source>Click to look from the right; drag to turn the view.</source>
        <translation>Fai clic per guardare da destra; trascina per ruotare la vista.</translation>
    </message>
    <message>
        <source>Click to look from the top; drag to turn the view.</source>
        <translation>Fai clic per guardare dall’alto; trascina per ruotare la vista.</translation>
    </message>
    <message>
        <source>Click to look from below; drag to turn the view.</source>
        <translation>Fai clic per guardare dal basso; trascina per ruotare la vista.</translation>
    </message>
    <message>
        <source>Click to look at this edge; drag to turn the view.</source>
        <translation>Fai clic per guardare questo spigolo; trascina per ruotare la vista.</translation>
    </message>
    <message>
        <source>Click to look at this corner; drag to turn the view.</source>
        <translation>Fai clic per guardare questo angolo; trascina per ruotare la vista.</translation>
    </message>
    <message>
        <source>Drag to turn the view; the wheel zooms.</source>
        <translation>Trascina per ruotare la vista; la rotella ingrandisce e rimpicciolisce.</translation>
    </message>
    <message>
        <source>Release to leave it here: the slit of %1 takes %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rilascia per lasciarlo qui: la fessura di %1 prende il %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Click a place on a section to put %1 there. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Fai clic in un punto di una sezione per mettere lì %1. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Press on a section and drag in the direction of the push. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Premi su una sezione e trascina nella direzione della spinta. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Press on a section and drag to pull it and see what happens; nothing is kept.</source>
        <translation>Premi su una sezione e trascina per tirarla e vedere che cosa succede; non resta nulla.</translation>
    </message>
    <message>
        <source>Release to let it go: nothing is kept.</source>
        <translation>Rilascia per lasciarla andare: non resta nulla.</translation>
    </message>
    <message>
        <source>Drag to move it. &lt;b&gt;Click&lt;/b&gt; selects it.</source>
        <translation>Trascina per spostarlo. Un &lt;b&gt;clic&lt;/b&gt; lo seleziona.</translation>
    </message>
    <message>
        <source>Drag the tip to turn the push; a longer arrow pushes harder.</source>
        <translation>Trascina la punta per ruotare la spinta; una freccia più lunga spinge di più.</translation>
    </message>
    <message>
        <source>Release to put the weight here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Rilascia per mettere qui il peso. &lt;kbd&gt;Esc&lt;/kbd&gt; lo rimette dov’era.</translation>
    </message>
    <message>
        <source>Release to push here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>Rilascia per spingere qui. &lt;kbd&gt;Esc&lt;/kbd&gt; la rimette dov’era.</translation>
    </message>
    <message>
        <source>No weight added: click on a section.</source>
        <translation>Nessun peso aggiunto: fai clic su una sezione.</translation>
    </message>
    <message>
        <source>No push added: press on a section.</source>
        <translation>Nessuna spinta aggiunta: premi su una sezione.</translation>
    </message>
    <message>
        <source>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Anche la copia di %1 lo porta; in &lt;i&gt;Proprietà&lt;/i&gt; lo puoi limitare a questa.</translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>Anche %n copia di %1 lo porta; in &lt;i&gt;Proprietà&lt;/i&gt; lo puoi limitare a questa.</numerusform>
            <numerusform>Anche %n copie di %1 lo portano; in &lt;i&gt;Proprietà&lt;/i&gt; lo puoi limitare a questa.</numerusform>
        </translation>
    </message>
    <message>
        <source>The weight stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Il peso resta dov’è: lì sarebbe fuori da %1.</translation>
    </message>
    <message>
        <source>The push stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>La spinta resta dov’è: lì sarebbe fuori da %1.</translation>
    </message>
    <message>
        <source>Drag to set how far %1 pulls templates.</source>
        <translation>Trascina per impostare fin dove %1 attrae i riferimenti.</translation>
    </message>
    <message>
        <source>Release to let %1 pull templates from %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Rilascia perché %1 attragga i riferimenti da %2. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Draw on the section to engrave, or click it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Disegna sulla sezione da incidere o fai clic su di essa. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Drag to draw a line on %1; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps it straight. Click to place text.</source>
        <translation>Trascina per tracciare una linea su %1; &lt;kbd&gt;Maiusc&lt;/kbd&gt; la tiene dritta. Fai clic per mettere un testo.</translation>
    </message>
    <message>
        <source>Release to keep the line. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rilascia per conservare la linea. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>%1 is engraved on its front, the one face that the laser reaches; the view has turned to it.</source>
        <extracomment>%1 is the name of a section, seen from behind until now</extracomment>
        <translation>%1 viene incisa sul fronte, l’unica faccia che il laser raggiunge; la vista si è girata da quella parte.</translation>
    </message>
    <message>
        <source>Nothing engraved: that is not on %1.</source>
        <translation>Nulla di inciso: non è su %1.</translation>
    </message>
    <message>
        <source>The character “%1” cannot be engraved.</source>
        <translation>Il carattere “%1” non si può incidere.</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Trascina da un punto a un altro per misurare; &lt;kbd&gt;Ctrl&lt;/kbd&gt; non aggancia. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Move to the second place. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Vai al secondo punto. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Click or drag to measure again. &lt;kbd&gt;Esc&lt;/kbd&gt; clears it.</source>
        <translation>Fai clic o trascina per misurare di nuovo. &lt;kbd&gt;Esc&lt;/kbd&gt; cancella la misura.</translation>
    </message>
    <message>
        <source>Drag along something whose length you know; the whole model follows. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>Trascina lungo qualcosa di cui conosci la lunghezza; tutto il modello si adegua. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Type the length you want; &lt;kbd&gt;Enter&lt;/kbd&gt; scales the whole model. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Scrivi la lunghezza che vuoi; &lt;kbd&gt;Invio&lt;/kbd&gt; scala tutto il modello. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>The model cannot be made that large or small.</source>
        <translation>Il modello non può diventare così grande o così piccolo.</translation>
    </message>
    <message>
        <source>The model cannot be scaled that far: %1 would go beyond its limits.</source>
        <translation>Il modello non si può scalare così tanto: %1 uscirebbe dai suoi limiti.</translation>
    </message>
    <message>
        <source>Click the section to mirror across; drag to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Fai clic sulla sezione rispetto a cui specchiare; trascina per ruotare la vista. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>B: make it a circle</source>
        <translation>B: fanne un cerchio</translation>
    </message>
    <message>
        <source>B: make it an ellipse</source>
        <translation>B: fanne un’ellisse</translation>
    </message>
    <message>
        <source>B: make its lines straight</source>
        <translation>B: raddrizza le linee</translation>
    </message>
    <message>
        <source>B: square the corners</source>
        <translation>B: metti gli angoli a squadra</translation>
    </message>
    <message>
        <source>B: move its slit in from the edge</source>
        <translation>B: allontana la fessura dal bordo</translation>
    </message>
    <message>
        <source>Made it a circle.</source>
        <translation>Ora è un cerchio.</translation>
    </message>
    <message>
        <source>Made it an ellipse.</source>
        <translation>Ora è un’ellisse.</translation>
    </message>
    <message>
        <source>Lines straightened.</source>
        <translation>Linee raddrizzate.</translation>
    </message>
    <message>
        <source>Corners squared.</source>
        <translation>Angoli messi a squadra.</translation>
    </message>
    <message>
        <source>Moved in from the edge.</source>
        <translation>Allontanata dal bordo.</translation>
    </message>
    <message>
        <source>%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across the edge, not along it.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 resta dove è stata disegnata: spostata in dentro, la sua fessura taglierebbe %2. Disegna attraverso il bordo, non lungo il bordo.</translation>
    </message>
    <message>
        <source>Release to start %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Rilascia per far iniziare %1 qui: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Release to end %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>Rilascia per far finire %1 qui: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Drag out of a section to draw across it with the pen; drag here to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Trascina fuori da una sezione per disegnare di traverso con la penna; trascina qui per ruotare la vista. &lt;kbd&gt;Esc&lt;/kbd&gt; posa la penna.</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw across it with the pen; click to select it.</source>
        <translation>Trascina fuori da %1 per disegnare di traverso con la penna; fai clic per selezionarla.</translation>
    </message>
    <message>
        <source>Click to set the first point, drag to bend. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>Fai clic per inserire il primo punto, trascina per curvare. &lt;kbd&gt;Esc&lt;/kbd&gt; posa la penna.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back.</source>
        <translation>Fai clic per inserire un punto, trascina per curvare; &lt;kbd&gt;Invio&lt;/kbd&gt; chiude, &lt;kbd&gt;Backspace&lt;/kbd&gt; ne toglie uno.</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back. &lt;kbd&gt;Ctrl&lt;/kbd&gt;+click sets it without snapping.</source>
        <translation>Fai clic per inserire un punto, trascina per curvare; &lt;kbd&gt;Invio&lt;/kbd&gt; chiude, &lt;kbd&gt;Backspace&lt;/kbd&gt; ne toglie uno. Il clic con &lt;kbd&gt;Ctrl&lt;/kbd&gt; non aggancia.</translation>
    </message>
    <message>
        <source>The contour crosses itself: &lt;kbd&gt;Enter&lt;/kbd&gt; keeps the largest loop, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes a point back.</source>
        <translation>Il contorno incrocia sé stesso: &lt;kbd&gt;Invio&lt;/kbd&gt; tiene l’anello più grande, &lt;kbd&gt;Backspace&lt;/kbd&gt; toglie un punto.</translation>
    </message>
    <message>
        <source>Drag to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Trascina per curvare; &lt;kbd&gt;Ctrl&lt;/kbd&gt; fa un angolo, &lt;kbd&gt;Maiusc&lt;/kbd&gt; mantiene la direzione.</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>Trascina per spostare il punto; &lt;kbd&gt;Ctrl&lt;/kbd&gt; non aggancia, &lt;kbd&gt;Maiusc&lt;/kbd&gt; mantiene la direzione.</translation>
    </message>
    <message>
        <source>Drag the handle to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner.</source>
        <translation>Trascina la maniglia per curvare; &lt;kbd&gt;Ctrl&lt;/kbd&gt; fa un angolo.</translation>
    </message>
    <message>
        <source>Click to close the contour; drag to move the point.</source>
        <translation>Fai clic per chiudere il contorno; trascina per spostare il punto.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; sets the point, &lt;kbd&gt;Tab&lt;/kbd&gt; goes to the next number. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the bar.</source>
        <translation>&lt;kbd&gt;Invio&lt;/kbd&gt; inserisce il punto, &lt;kbd&gt;Tab&lt;/kbd&gt; passa al numero successivo. &lt;kbd&gt;Esc&lt;/kbd&gt; chiude la barra.</translation>
    </message>
    <message>
        <source>Not closed: the points enclose nothing yet.</source>
        <translation>Non chiuso: i punti non racchiudono ancora nulla.</translation>
    </message>
    <message>
        <source>A contour is still open: &lt;kbd&gt;Enter&lt;/kbd&gt; closes it, &lt;kbd&gt;Esc&lt;/kbd&gt; takes it back.</source>
        <translation>Un contorno è ancora aperto: &lt;kbd&gt;Invio&lt;/kbd&gt; lo chiude, &lt;kbd&gt;Esc&lt;/kbd&gt; lo toglie.</translation>
    </message>
    <message>
        <source>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence: &quot;Click the section to repeat.&quot;</extracomment>
        <translation>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Finora: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; makes it.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1 Finora: %2. &lt;kbd&gt;Invio&lt;/kbd&gt; conferma.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Invio&lt;/kbd&gt; conferma. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Release to leave it here. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Rilascia per lasciarlo qui. &lt;kbd&gt;Ctrl&lt;/kbd&gt; fa un angolo, &lt;kbd&gt;Maiusc&lt;/kbd&gt; mantiene la direzione.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>Rilascia per lasciare così. &lt;kbd&gt;Ctrl&lt;/kbd&gt; fa un angolo, &lt;kbd&gt;Maiusc&lt;/kbd&gt; mantiene la direzione.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes corners at its ends. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rilascia per lasciare così. &lt;kbd&gt;Ctrl&lt;/kbd&gt; fa angoli alle estremità. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>The contour would cross itself here; it stays as it was just before.</source>
        <translation>Qui il contorno incrocerebbe sé stesso; resta com’era appena prima.</translation>
    </message>
    <message>
        <source>A hole would touch the edge or another hole here; it stays as it was just before.</source>
        <translation>Qui un foro toccherebbe il bordo o un altro foro; resta com’era appena prima.</translation>
    </message>
    <message>
        <source>All of %1 would be cut off at the ground here; it stays as it was.</source>
        <translation>Qui %1 verrebbe tagliata via tutta al suolo; resta com’era.</translation>
    </message>
    <message>
        <source>Nothing deleted: a contour needs at least two points.</source>
        <translation>Nulla di eliminato: un contorno ha bisogno di almeno due punti.</translation>
    </message>
    <message>
        <source>Release to select everything that is completely inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rilascia per selezionare tutto ciò che sta completamente dentro. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Release to select the points inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rilascia per selezionare i punti all’interno. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>%1 keeps its angle to %2. Free it to turn it as you like.</source>
        <translation>%1 mantiene il suo angolo con %2. Svincolala per ruotarla come vuoi.</translation>
    </message>
    <message>
        <source>%1 is not on another section, so it has no angle to one.</source>
        <translation>%1 non sta su un’altra sezione, quindi non ha un angolo con essa.</translation>
    </message>
    <message>
        <source>%1 cannot be on %2, which is on it.</source>
        <translation>%1 non può stare su %2, che sta su di lei.</translation>
    </message>
    <message>
        <source>%1 and %2 do not meet: move one of them across the other first.</source>
        <translation>%1 e %2 non si incontrano: sposta prima una attraverso l’altra.</translation>
    </message>
    <message>
        <source>Click the section to put %1 on. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Fai clic sulla sezione su cui mettere %1. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Space&lt;/kbd&gt; plays, &lt;kbd&gt;←&lt;/kbd&gt; and &lt;kbd&gt;→&lt;/kbd&gt; go step by step. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the steps.</source>
        <translation>Trascina per ruotare la vista; &lt;kbd&gt;Spazio&lt;/kbd&gt; riproduce, &lt;kbd&gt;←&lt;/kbd&gt; e &lt;kbd&gt;→&lt;/kbd&gt; vanno passo per passo. &lt;kbd&gt;Esc&lt;/kbd&gt; chiude i passi.</translation>
    </message>
    <message>
        <source>The model has changed, so the view of its steps was closed.</source>
        <translation>Il modello è cambiato, perciò la vista dei passi è stata chiusa.</translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Continua a trascinare per uscire da %1; la fessura finisce al bordo. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Drag on to leave %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves the slit as you draw it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Continua a trascinare per uscire da %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; lascia la fessura come la disegni. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>The view is turning: draw on at once, or wait until it stops.</source>
        <translation>La vista sta ruotando: continua subito a disegnare o aspetta che si fermi.</translation>
    </message>
    <message>
        <source>Draw the outline: leave the grey zone where it should start. Release here to cancel.</source>
        <translation>Disegna il contorno: esci dalla zona grigia dove deve iniziare. Rilascia qui per annullare.</translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Disegna il contorno, rilascia per chiuderlo. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Rilascia&lt;/b&gt; per fare la sezione. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to cut the hole into %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Rilascia&lt;/b&gt; per tagliare il foro in %1. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>&lt;b&gt;Rilascia&lt;/b&gt; per dare a %1 questo contorno. &lt;kbd&gt;Esc&lt;/kbd&gt; lascia quello vecchio.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the slit. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Rilascia&lt;/b&gt; per fare la sezione, specchiata rispetto alla fessura. Tieni premuto &lt;kbd&gt;Maiusc&lt;/kbd&gt; per tenere solo questo lato. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored. Let &lt;kbd&gt;Shift&lt;/kbd&gt; go to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;Rilascia&lt;/b&gt; per fare la sezione, specchiata. Lascia &lt;kbd&gt;Maiusc&lt;/kbd&gt; per tenere solo questo lato. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour, mirrored across its slit. &lt;kbd&gt;Shift&lt;/kbd&gt; does the opposite.</source>
        <translation>&lt;b&gt;Rilascia&lt;/b&gt; per dare a %1 questo contorno, specchiato rispetto alla fessura. &lt;kbd&gt;Maiusc&lt;/kbd&gt; fa il contrario.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the vertical. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side.</source>
        <translation>&lt;b&gt;Rilascia&lt;/b&gt; per fare la sezione, specchiata rispetto alla verticale. Tieni premuto &lt;kbd&gt;Maiusc&lt;/kbd&gt; per tenere solo questo lato.</translation>
    </message>
    <message>
        <source>Follow the teal curve to snap to %1; hold &lt;kbd&gt;Ctrl&lt;/kbd&gt; to leave it. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; takes it whole.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Segui la curva verde acqua per agganciarti a %1; tieni premuto &lt;kbd&gt;Ctrl&lt;/kbd&gt; per lasciarla. &lt;kbd&gt;Maiusc+Invio&lt;/kbd&gt; la usa tutta.</translation>
    </message>
    <message>
        <source>Shift+Enter: take the whole guide</source>
        <translation>Maiusc+Invio: usa tutta la guida</translation>
    </message>
    <message>
        <source>The slit does not touch a guide, so there is none to take whole.</source>
        <translation>La fessura non tocca nessuna guida, quindi non ce n’è una da usare tutta.</translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge; &lt;kbd&gt;O&lt;/kbd&gt; draws holes, &lt;kbd&gt;E&lt;/kbd&gt; engraves.</source>
        <translation>Nulla di disegnato: la fessura non è mai uscita da %1. Comincia dentro e trascina attraverso il bordo; &lt;kbd&gt;O&lt;/kbd&gt; disegna fori, &lt;kbd&gt;E&lt;/kbd&gt; incide.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation>Nulla di disegnato: la linea è troppo corta per racchiudere qualcosa.</translation>
    </message>
    <message>
        <source>Nothing drawn: a line of less than %1 is taken for a slip of the hand, unless it closes a loop.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Nulla di disegnato: una linea più corta di %1 passa per un movimento involontario, se non chiude un anello.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line goes there and back and encloses nothing.</source>
        <translation>Nulla di disegnato: la linea va e torna e non racchiude nulla.</translation>
    </message>
    <message>
        <source>Nothing drawn: the line crosses itself, and no loop of it is large enough.</source>
        <translation>Nulla di disegnato: la linea incrocia sé stessa e nessuno dei suoi anelli è abbastanza grande.</translation>
    </message>
    <message>
        <source>%1 was not mirrored: the two halves would not meet.</source>
        <translation>%1 non è stata specchiata: le due metà non si toccherebbero.</translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept.</source>
        <translation>Il contorno incrocia sé stesso; è rimasto l’anello più grande.</translation>
    </message>
    <message>
        <source>%1 was mirrored; what crossed its axis and came back was left out.</source>
        <translation>%1 è stata specchiata; ciò che passava l’asse e tornava indietro è stato omesso.</translation>
    </message>
    <message>
        <source>%1 does not reach its slit: nothing joins it to %2.</source>
        <extracomment>%2 is the section that the slit is in</extracomment>
        <translation>%1 non raggiunge la sua fessura: nulla la collega a %2.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.</source>
        <translation>%1 è stata disegnata accanto alla sua fessura: ha ricevuto un raccordo ed è stata tagliata a filo del suolo.</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit and was given a neck that reaches into it.</source>
        <translation>%1 è stata disegnata accanto alla sua fessura e ha ricevuto un raccordo che ci arriva.</translation>
    </message>
    <message>
        <source>%1 is not symmetric: its halves differ.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 non è simmetrica: le sue metà sono diverse.</translation>
    </message>
    <message>
        <source>Drag an arrow to move %1, a ring to turn it, a box to scale it; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Trascina una freccia per spostare %1, un anello per ruotarlo, un quadratino per scalarlo; oppure scrivi i numeri. &lt;kbd&gt;Esc&lt;/kbd&gt; nasconde le maniglie.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Trascina per spostare; &lt;kbd&gt;Maiusc&lt;/kbd&gt; mantiene una direzione.</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>Trascina per ruotare.</translation>
    </message>
    <message>
        <source>Drag to scale.</source>
        <translation>Trascina per scalare.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rilascia per lasciare così. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>%1 is locked.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 è bloccato.</translation>
    </message>
    <message>
        <source>%1 cannot be moved or scaled that far.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 non si può spostare o scalare così tanto.</translation>
    </message>
    <message>
        <source>Drag along something in %1 whose length you know; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to eight directions. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Trascina lungo qualcosa in %1 di cui conosci la lunghezza; &lt;kbd&gt;Maiusc&lt;/kbd&gt; si limita a otto direzioni. &lt;kbd&gt;Esc&lt;/kbd&gt; termina.</translation>
    </message>
    <message>
        <source>Type how long that is; &lt;kbd&gt;Enter&lt;/kbd&gt; makes %1 that large. &lt;kbd&gt;Esc&lt;/kbd&gt; clears the line.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Scrivi quanto è lungo; &lt;kbd&gt;Invio&lt;/kbd&gt; porta %1 a quella misura. &lt;kbd&gt;Esc&lt;/kbd&gt; cancella la linea.</translation>
    </message>
    <message>
        <source>No flat piece of %1 is large enough for a section: make it larger first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Nessuna parte piana di %1 è abbastanza grande per una sezione: ingrandisci prima il riferimento.</translation>
    </message>
    <message>
        <source>It has more than %1 flat pieces: choose fewer faces.</source>
        <translation>Ha più di %1 parti piane: scegli meno facce.</translation>
    </message>
    <message>
        <source>A sheet of %1 does not fold: choose a stock of %2 or less.</source>
        <extracomment>A sheet. %1 and %2 are lengths</extracomment>
        <translation>Una lastra da %1 non si piega: scegli un materiale da %2 o meno.</translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>Piega lungo le linee cordonate, poi unisci i bordi con lo stesso numero: %n giunzione.</numerusform>
            <numerusform>Piega lungo le linee cordonate, poi unisci i bordi con lo stesso numero: %n giunzioni.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click the section to move or turn, or drag it. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Fai clic sulla sezione da spostare o ruotare, o trascinala. &lt;kbd&gt;Esc&lt;/kbd&gt; nasconde le maniglie.</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, a box to scale; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>Trascina una freccia per spostare, un anello per ruotare, un quadratino per scalare; oppure scrivi i numeri. &lt;kbd&gt;Esc&lt;/kbd&gt; nasconde le maniglie.</translation>
    </message>
    <message>
        <source>Drag to move %1; click to select it.</source>
        <translation>Trascina per spostare %1; fai clic per selezionarla.</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>Trascina per spostare; &lt;kbd&gt;Ctrl&lt;/kbd&gt; lascia una copia, &lt;kbd&gt;Maiusc&lt;/kbd&gt; mantiene una direzione.</translation>
    </message>
    <message>
        <source>Drag to turn; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Trascina per ruotare; &lt;kbd&gt;Ctrl&lt;/kbd&gt; lascia una copia.</translation>
    </message>
    <message>
        <source>Drag to scale; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>Trascina per scalare; &lt;kbd&gt;Ctrl&lt;/kbd&gt; lascia una copia.</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rilascia per lasciare così. &lt;kbd&gt;Ctrl&lt;/kbd&gt; lascia una copia, &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Release to leave a copy here. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rilascia per lasciare qui una copia. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; keeps it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Invio&lt;/kbd&gt; lascia così. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Invio&lt;/kbd&gt; fa %n copia così. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</numerusform>
            <numerusform>&lt;kbd&gt;Invio&lt;/kbd&gt; fa %n copie così, ognuna un passo più avanti. &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</numerusform>
        </translation>
    </message>
    <message>
        <source>A preset needs a name, without “=” and blanks at its ends.</source>
        <translation>Una preimpostazione ha bisogno di un nome, senza “=” e senza spazi alle estremità.</translation>
    </message>
    <message>
        <source>Others can adjust no value yet, so there is nothing to keep.</source>
        <translation>Gli altri non possono ancora regolare nessun valore, quindi non c’è nulla da conservare.</translation>
    </message>
    <message>
        <source>There is no preset named “%1”.</source>
        <extracomment>%1 is what somebody took for the name of a preset</extracomment>
        <translation>Non c’è nessuna preimpostazione di nome “%1”.</translation>
    </message>
    <message>
        <source>This is what others see. Save the file and give it to them; it opens like this.</source>
        <translation>Questo è ciò che vedono gli altri. Salva il file e daglielo: si apre così.</translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>%n numero che ne dipendeva ora è un numero semplice.</numerusform>
            <numerusform>%n numeri che ne dipendevano ora sono numeri semplici.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>Con esso sparisce %n preimpostazione che non imposta altro.</numerusform>
            <numerusform>Con esso spariscono %n preimpostazioni che non impostano altro.</numerusform>
        </translation>
    </message>
    <message>
        <source>No narrower ranges were found in which the model holds.</source>
        <translation>Non sono stati trovati intervalli più stretti in cui il modello regge.</translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation>Muovi per ruotare la vista, rilascia per finire.</translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation>Muovi per spostare la vista, rilascia per finire.</translation>
    </message>
    <message>
        <source>Move up to zoom in, down to zoom out; release to stop.</source>
        <translation>Muovi in su per ingrandire, in giù per rimpicciolire; rilascia per finire.</translation>
    </message>
    <message>
        <source>Nothing changed: this cannot be done here.</source>
        <translation>Nulla è cambiato: qui non si può fare.</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it in the Outline to change it.</source>
        <translation>%1 è bloccata. Sbloccala nella Struttura per modificarla.</translation>
    </message>
    <message>
        <source>%1 is made by %2: edit its source, or detach this one.</source>
        <translation>%1 è creata da %2: modifica l’originale o stacca questa.</translation>
    </message>
    <message>
        <source>Nothing would be left of %1; it stays as it was.</source>
        <translation>Non resterebbe nulla di %1; resta com’era.</translation>
    </message>
    <message>
        <source>%1 was cut flat at the ground.</source>
        <translation>%1 è stata tagliata a filo del suolo.</translation>
    </message>
    <message>
        <source>%1 fell apart when it was cut flat at the ground; the largest piece was kept.</source>
        <translation>%1 si è divisa quando è stata tagliata a filo del suolo; è rimasta la parte più grande.</translation>
    </message>
    <message>
        <source>Nothing pasted: what was copied has neither sections nor a picture in it.</source>
        <translation>Nulla di incollato: in ciò che è stato copiato non ci sono né sezioni né un’immagine.</translation>
    </message>
    <message>
        <source>Nothing copied: the model is symmetric already.</source>
        <translation>Nulla di copiato: il modello è già simmetrico.</translation>
    </message>
    <message>
        <source>Nothing deleted: a joint is where two sections meet. Delete one of them, or choose the kind “None”.</source>
        <translation>Nulla di eliminato: un incastro è il punto in cui due sezioni si incontrano. Elimina una delle due o scegli il tipo “Nessuno”.</translation>
    </message>
    <message>
        <source>“%1” is what is set now, in place of what it was.</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>«%1» ora è ciò che è impostato, al posto di ciò che era.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to mirror yet.</source>
        <translation>Disegna prima una sezione: non c’è ancora nulla da specchiare.</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to repeat or divide yet.</source>
        <translation>Disegna prima una sezione: non c’è ancora nulla da ripetere o dividere.</translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n bordo non ha denti: lì le lastre si incontrano con un angolo troppo piatto o troppo acuto, o è troppo corto. Servono meno facce, oppure delle fette.</numerusform>
            <numerusform>%n bordi non hanno denti: lì le lastre si incontrano con un angolo troppo piatto o troppo acuto, o sono troppo corti. Servono meno facce, oppure delle fette.</numerusform>
        </translation>
    </message>
    <message>
        <source>Adds a mirror image of what is selected. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Aggiunge un’immagine speculare della selezione. &lt;kbd&gt;Invio&lt;/kbd&gt; specchia; &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>What you change on one side changes on the other. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Ciò che cambi su un lato cambia anche sull’altro. &lt;kbd&gt;Invio&lt;/kbd&gt; specchia; &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
    </message>
    <message>
        <source>Makes both sides the same once; then each is its own. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>Rende uguali i due lati una volta; poi ognuno va per conto suo. &lt;kbd&gt;Invio&lt;/kbd&gt; specchia; &lt;kbd&gt;Esc&lt;/kbd&gt; annulla.</translation>
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
        <translation>Bicchiere d’acqua</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>Forchetta</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>Coltello</translation>
    </message>
    <message>
        <source>Spoon</source>
        <translation>Cucchiaio</translation>
    </message>
    <message>
        <source>Book</source>
        <translation>Libro</translation>
    </message>
    <message>
        <source>Plant pot</source>
        <translation>Vaso da fiori</translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message>
        <source>A face was left out: a corner of it is not there.</source>
        <translation>Una faccia è stata omessa: uno dei suoi vertici non esiste.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>%n faccia è stata omessa: uno dei suoi vertici non esiste.</numerusform>
            <numerusform>%n facce sono state omesse: uno dei loro vertici non esiste.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: the place of a corner is no number.</source>
        <translation>Una faccia è stata omessa: la posizione di un vertice non è un numero.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>%n faccia è stata omessa: la posizione di un vertice non è un numero.</numerusform>
            <numerusform>%n facce sono state omesse: la posizione di un vertice non è un numero.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it has a corner twice.</source>
        <translation>Una faccia è stata omessa: ha due volte lo stesso vertice.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>%n faccia è stata omessa: ha due volte lo stesso vertice.</numerusform>
            <numerusform>%n facce sono state omesse: hanno due volte lo stesso vertice.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it is there twice.</source>
        <translation>Una faccia è stata omessa: c’è due volte.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>%n faccia è stata omessa: c’è due volte.</numerusform>
            <numerusform>%n facce sono state omesse: ci sono due volte.</numerusform>
        </translation>
    </message>
    <message>
        <source>A face looked the wrong way and was turned over.</source>
        <translation>Una faccia guardava dalla parte sbagliata ed è stata girata.</translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>%n faccia guardava dalla parte sbagliata ed è stata girata.</numerusform>
            <numerusform>%n facce guardavano dalla parte sbagliata e sono state girate.</numerusform>
        </translation>
    </message>
    <message>
        <source>The surface has a hole: an edge is open.</source>
        <translation>La superficie ha un buco: uno spigolo è aperto.</translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>La superficie ha dei buchi: %n spigolo è aperto.</numerusform>
            <numerusform>La superficie ha dei buchi: %n spigoli sono aperti.</numerusform>
        </translation>
    </message>
    <message>
        <source>More than two faces meet at an edge.</source>
        <translation>In uno spigolo si incontrano più di due facce.</translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>In %n spigolo si incontrano più di due facce.</numerusform>
            <numerusform>In %n spigoli si incontrano più di due facce.</numerusform>
        </translation>
    </message>
    <message>
        <source>At an edge faces meet that cannot look the same way.</source>
        <translation>In uno spigolo si incontrano facce che non possono guardare dalla stessa parte.</translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>In %n spigolo si incontrano facce che non possono guardare dalla stessa parte.</numerusform>
            <numerusform>In %n spigoli si incontrano facce che non possono guardare dalla stessa parte.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was inside out and was turned over.</source>
        <translation>Era rovesciata, con l’interno all’esterno, ed è stata girata.</translation>
    </message>
    <message>
        <source>A gap in the cut was closed by a smooth curve.</source>
        <translation>Un’interruzione nel taglio è stata chiusa con una curva liscia.</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>%n interruzione nel taglio è stata chiusa con una curva liscia.</numerusform>
            <numerusform>%n interruzioni nel taglio sono state chiuse con curve lisce.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MirrorBar</name>
    <message>
        <source>Plane</source>
        <extracomment>before the buttons X, Y, Z and Section, the plane that is mirrored across</extracomment>
        <translation>Piano</translation>
    </message>
    <message>
        <source>How</source>
        <extracomment>before the buttons Copy, Both sides and Once</extracomment>
        <translation>Come</translation>
    </message>
</context>
<context>
    <name>Offcut</name>
    <message>
        <source>%1 does not say how large it is in mm or inches; the offcut is taken as %2 × %3 mm.</source>
        <extracomment>%1 is a file&apos;s name, %2 x %3 the size of an offcut</extracomment>
        <translation>%1 non dice quanto è grande in mm o pollici; il ritaglio è preso come %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: the outline crosses itself; the largest piece of it is taken, %2 × %3 mm.</source>
        <translation>%1: la sagoma si incrocia; è preso il suo pezzo più grande, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines cut the offcut into pieces; the largest is taken, %2 × %3 mm.</source>
        <translation>%1: alcune linee tagliano il ritaglio a pezzi; è preso il più grande, %2 × %3 mm.</translation>
    </message>
    <message>
        <source>%1: lines in the offcut are open; what they would enclose if they were closed is left free.</source>
        <extracomment>%1 is a file&apos;s name</extracomment>
        <translation>%1: alcune linee nel ritaglio sono aperte; ciò che racchiuderebbero da chiuse resta libero.</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Count</source>
        <translation>Numero</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linea</translation>
    </message>
    <message>
        <source>Including the sections that are there already</source>
        <translation>Comprese le sezioni che ci sono già</translation>
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
        <translation>Serie</translation>
    </message>
    <message>
        <source>Repeats sections along a line through space.</source>
        <translation>Ripete sezioni lungo una linea nello spazio.</translation>
    </message>
    <message>
        <source>%1 array</source>
        <extracomment>%1 is the name of a section: &quot;Rib array&quot;</extracomment>
        <translation>Serie di %1</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Sezioni</translation>
    </message>
    <message>
        <source>Click the sections to repeat.</source>
        <translation>Fai clic sulle sezioni da ripetere.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Transizione</translation>
    </message>
    <message>
        <source>Interpolates between sections.</source>
        <translation>Interpola tra sezioni.</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <extracomment>%1 is the name of a section: &quot;Rib blend&quot;</extracomment>
        <translation>Transizione di %1</translation>
    </message>
    <message>
        <source>Click the sections to blend, in order.</source>
        <translation>Fai clic sulle sezioni da far passare l’una nell’altra, in ordine.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Lungo</translation>
    </message>
    <message>
        <source>Click the section it should run along.</source>
        <translation>Fai clic sulla sezione lungo cui deve correre.</translation>
    </message>
    <message>
        <source>Count per gap</source>
        <translation>Numero per intervallo</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Collocazione</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Andamento</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Uniforme</translation>
    </message>
    <message>
        <source>Slow ends</source>
        <translation>Estremi lenti</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Corrispondenza</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatica</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Come disegnata</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Invertita</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterazioni</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Crescita</translation>
    </message>
    <message>
        <source>Size of a copy</source>
        <translation>Misura di una copia</translation>
    </message>
    <message>
        <source>Vary size ±</source>
        <translation>Varia misura ±</translation>
    </message>
    <message>
        <source>Vary angle ±</source>
        <translation>Varia angolo ±</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Seme</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Misura minima</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limiti</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Al massimo</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ramificazione</translation>
    </message>
    <message>
        <source>Grows copies of a section and all that is on it in place of its children, again and again.</source>
        <translation>Fa crescere copie di una sezione e di tutto ciò che vi sta sopra al posto delle sue figlie, ancora e ancora.</translation>
    </message>
    <message>
        <source>%1 branch</source>
        <extracomment>%1 is the name of a section: &quot;Rib branch&quot;</extracomment>
        <translation>Ramificazione di %1</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>Radice</translation>
    </message>
    <message>
        <source>Click the section that branches.</source>
        <translation>Fai clic sulla sezione che si ramifica.</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Tenuta da</translation>
    </message>
    <message>
        <source>Click the section that holds it: copies are held the same way.</source>
        <translation>Fai clic sulla sezione che la tiene: le copie sono tenute allo stesso modo.</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Figlie</translation>
    </message>
    <message>
        <source>Click the attached sections that copies should replace.</source>
        <translation>Fai clic sulle sezioni attaccate che le copie devono sostituire.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Griglia</translation>
    </message>
    <message>
        <source>Divides a section that is too large into cells that hold together.</source>
        <translation>Divide una sezione troppo grande in celle che restano insieme.</translation>
    </message>
    <message>
        <source>%1 grid</source>
        <extracomment>%1 is the name of a section: &quot;Rib grid&quot;</extracomment>
        <translation>Griglia di %1</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sezione</translation>
    </message>
    <message>
        <source>Click the section to divide.</source>
        <translation>Fai clic sulla sezione da dividere.</translation>
    </message>
    <message>
        <source>Fit my sheet</source>
        <translation>Adatta alla lastra</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Celle</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>Larghezza cella</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>Altezza cella</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Bordo</translation>
    </message>
    <message>
        <source>Straight with connectors</source>
        <translation>Dritto con connettori</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>Puzzle</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Bordi</translation>
    </message>
    <message>
        <source>Connectors per edge</source>
        <translation>Connettori per bordo</translation>
    </message>
    <message>
        <source>Connector size</source>
        <translation>Misura dei connettori</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Gioco</translation>
    </message>
    <message>
        <source>Merge slivers below</source>
        <translation>Unisci resti sotto</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lato</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Avanti</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Entrambi</translation>
    </message>
    <message>
        <source>Equal depth inside</source>
        <translation>Pari profondità interna</translation>
    </message>
    <message>
        <source>The same length of each copy lies inside the other section</source>
        <translation>Di ogni copia la stessa lunghezza sta dentro l’altra sezione</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Fila</translation>
    </message>
    <message>
        <source>Repeats a section in a row along another one.</source>
        <translation>Ripete una sezione in fila lungo un’altra.</translation>
    </message>
    <message>
        <source>%1 row</source>
        <extracomment>%1 is the name of a section: &quot;Rib row&quot;</extracomment>
        <translation>Fila di %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cerchio</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stella</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>Ingranaggio</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Fori</translation>
    </message>
    <message>
        <source>Drawn sector</source>
        <translation>Settore disegnato</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>Settori</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>Raggio esterno</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Raggio interno</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Dente</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Tondo</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrato</translation>
    </message>
    <message>
        <source>Trapezium</source>
        <translation>Trapezio</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Apply to</source>
        <translation>Applica a</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>%1 circle</source>
        <translation>Cerchio di %1</translation>
    </message>
    <message>
        <source>%1 star</source>
        <translation>Stella di %1</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>Fori di %1</translation>
    </message>
    <message>
        <source>%1 rosette</source>
        <translation>Rosetta di %1</translation>
    </message>
    <message>
        <source>%1 gear</source>
        <translation>Ingranaggio di %1</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radiale</translation>
    </message>
    <message>
        <source>Turns a section into a circle, a star or a gear, or cuts such holes into it.</source>
        <translation>Trasforma una sezione in un cerchio, una stella o un ingranaggio, o ci taglia fori così.</translation>
    </message>
    <message>
        <source>Click the section to shape.</source>
        <translation>Fai clic sulla sezione da modellare.</translation>
    </message>
    <message>
        <source>Click the section to repeat.</source>
        <translation>Fai clic sulla sezione da ripetere.</translation>
    </message>
    <message>
        <source>Whole branch</source>
        <translation>Ramo intero</translation>
    </message>
    <message>
        <source>With everything that is attached to it</source>
        <translation>Con tutto ciò che vi è attaccato</translation>
    </message>
    <message>
        <source>Repeat by</source>
        <translation>Ripeti per</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Da</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Scala</translation>
    </message>
    <message>
        <source>No</source>
        <translation>No</translation>
    </message>
    <message>
        <source>By local thickness</source>
        <translation>Per spessore locale</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direzione</translation>
    </message>
    <message>
        <source>Whole section</source>
        <translation>Sezione intera</translation>
    </message>
    <message>
        <source>Along the slit</source>
        <translation>Lungo la fessura</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensità</translation>
    </message>
    <message>
        <source>Not below</source>
        <translation>Non sotto</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Fuori</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Dentro</translation>
    </message>
    <message>
        <source>Angle to edge</source>
        <translation>Angolo col bordo</translation>
    </message>
    <message>
        <source>All the way round</source>
        <translation>Giro completo</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Repeats a section round the contour of another one.</source>
        <translation>Ripete una sezione tutt’intorno al contorno di un’altra.</translation>
    </message>
    <message>
        <source>%1 fan</source>
        <extracomment>%1 is the name of a section: &quot;Rib fan&quot;</extracomment>
        <translation>Ventaglio di %1</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Piani</translation>
    </message>
    <message>
        <source>across X</source>
        <translation>perpendicolari a X</translation>
    </message>
    <message>
        <source>across Y</source>
        <translation>perpendicolari a Y</translation>
    </message>
    <message>
        <source>across Z</source>
        <translation>perpendicolari a Z</translation>
    </message>
    <message>
        <source>across X and Y</source>
        <translation>perpendicolari a X e Y</translation>
    </message>
    <message>
        <source>across X and Z</source>
        <translation>perpendicolari a X e Z</translation>
    </message>
    <message>
        <source>across Y and Z</source>
        <translation>perpendicolari a Y e Z</translation>
    </message>
    <message>
        <source>along a curve</source>
        <translation>lungo una curva</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Fette</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Per</translation>
    </message>
    <message>
        <source>In each direction</source>
        <translation>In ogni direzione</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Sfasamento</translation>
    </message>
    <message>
        <source>Of all planes, as a part of their spacing</source>
        <translation>Di tutti i piani, come parte della loro distanza</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>Area minima</translation>
    </message>
    <message>
        <source>In mm²; smaller ones are left out, and those that are thin all over</source>
        <translation>In mm²; le sezioni più piccole vengono omesse, come quelle sottili dappertutto</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Cavo all’interno</translation>
    </message>
    <message>
        <source>Only a wall along the contour is left</source>
        <translation>Resta solo una parete lungo il contorno</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Parete</translation>
    </message>
    <message>
        <source>Cuts a mesh into sections that follow its form.</source>
        <translation>Taglia una mesh in sezioni che ne seguono la forma.</translation>
    </message>
    <message>
        <source>Click the section whose contour it should run along.</source>
        <translation>Fai clic sulla sezione lungo il cui contorno deve correre.</translation>
    </message>
    <message>
        <source>Click the sections that it applies to.</source>
        <translation>Fai clic sulle sezioni a cui si applica.</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>Si applica a</translation>
    </message>
    <message>
        <source>Whole model</source>
        <translation>Modello intero</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Selezione</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Specchio</translation>
    </message>
    <message>
        <source>Repeats everything drawn on one side on the other.</source>
        <translation>Ripete sull’altro lato tutto ciò che è disegnato su uno.</translation>
    </message>
    <message>
        <source>Click the section to mirror across.</source>
        <translation>Fai clic sulla sezione rispetto a cui specchiare.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Piano</translation>
    </message>
    <message>
        <source>A section&apos;s plane</source>
        <translation>Piano di una sezione</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simmetria</translation>
    </message>
    <message>
        <source>Join at the plane</source>
        <translation>Collega sul piano</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>Rotazionale</translation>
    </message>
    <message>
        <source>Repeats everything drawn once all round an axis.</source>
        <translation>Ripete tutt’intorno a un asse tutto ciò che è disegnato una volta.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Asse</translation>
    </message>
    <message>
        <source>Click the two sections whose slit is the axis.</source>
        <translation>Fai clic sulle due sezioni la cui fessura è l’asse.</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Verticale</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fessura</translation>
    </message>
    <message>
        <source>like a section</source>
        <translation>come una sezione</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>attorno a Y</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>attorno a X</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>attorno a Z</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>Come</translation>
    </message>
    <message>
        <source>Click the section that they should be parallel to.</source>
        <translation>Fai clic sulla sezione a cui devono essere parallele.</translation>
    </message>
</context>
<context>
    <name>OperationNotice</name>
    <message>
        <source>automatic</source>
        <translation>automatico</translation>
    </message>
    <message>
        <source>on</source>
        <translation>sì</translation>
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
        <translation>%1 non crea ancora nulla: scegli “%2”.</translation>
    </message>
    <message>
        <source>%1 has lost its section “%2”, which was deleted. It makes nothing until another one is chosen.</source>
        <extracomment>%1 is the name of an operation, %2 that of a section</extracomment>
        <translation>%1 ha perso la sezione “%2”, che è stata eliminata. Non crea nulla finché non ne scegli un’altra.</translation>
    </message>
    <message>
        <source>%1 makes nothing: its sections do not cross each other.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 non crea nulla: le sue sezioni non si incrociano.</translation>
    </message>
    <message>
        <source>%1 makes nothing: there is no room within its range.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 non crea nulla: nel suo intervallo non c’è spazio.</translation>
    </message>
    <message>
        <source>%1 has nothing to divide: the section fits into a single cell.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 non ha nulla da dividere: la sezione sta in una sola cella.</translation>
    </message>
    <message>
        <source>%1 could not be worked out: its sections are missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Impossibile calcolare %1: mancano le sue sezioni.</translation>
    </message>
    <message>
        <source>%1 stopped at 1 section.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 si è fermata a 1 sezione.</translation>
    </message>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1 si è fermata a %n sezione.</numerusform>
            <numerusform>%1 si è fermata a %n sezioni.</numerusform>
        </translation>
    </message>
    <message>
        <source>1 section of %1 was left out, as there is nothing to hold it.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 sezione di %1 è stata omessa, perché non c’è nulla che la tenga.</translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>%n sezione di %1 è stata omessa, perché non c’è nulla che la tenga.</numerusform>
            <numerusform>%n sezioni di %1 sono state omesse, perché non c’è nulla che le tenga.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 makes nothing: its template is gone or its file is missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 non crea nulla: il suo riferimento non c’è più o manca il suo file.</translation>
    </message>
    <message>
        <source>1 small piece of %1 was left out.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>1 piccola parte di %1 è stata omessa.</translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>%n piccola parte di %1 è stata omessa.</numerusform>
            <numerusform>%n piccole parti di %1 sono state omesse.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Pdf</name>
    <message>
        <source>%1 mm: print at 100 %</source>
        <translation>%1 mm: stampa al 100 %</translation>
    </message>
    <message>
        <source>Sheet %1, page %2</source>
        <translation>Lastra %1, pagina %2</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Sgancia</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
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
        <translation>Maiusc</translation>
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
        <translation>Fine</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Canc</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Ins</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Pag su</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Pag giù</translation>
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
        <translation>Invio</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Invio</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Spazio</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Su</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Giù</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Stopped: %1. It is worked out again when the model changes.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Fermato: %1. Verrà ricalcolato quando il modello cambia.</translation>
    </message>
    <message>
        <source>Could not be worked out: %1. Reason: %2.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;, %2 a sentence</extracomment>
        <translation>Impossibile calcolare: %1. Motivo: %2.</translation>
    </message>
    <message>
        <source>what can be done about problems</source>
        <translation>che cosa si può fare per i problemi</translation>
    </message>
    <message>
        <source>Working out %1…</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;</extracomment>
        <translation>Calcolo in corso: %1…</translation>
    </message>
    <message>
        <source>Working out %1… %2&#x202f;%</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;, %2 a number</extracomment>
        <translation>Calcolo in corso: %1… %2&#x202f;%</translation>
    </message>
    <message>
        <source>the joints and slits</source>
        <translation>gli incastri e le fessure</translation>
    </message>
    <message>
        <source>the checks</source>
        <translation>i controlli</translation>
    </message>
    <message>
        <source>the order of assembly</source>
        <translation>l’ordine di montaggio</translation>
    </message>
    <message>
        <source>whether it holds</source>
        <translation>se regge</translation>
    </message>
    <message>
        <source>how much it holds when sections bend</source>
        <translation>quanto regge quando le sezioni si flettono</translation>
    </message>
    <message>
        <source>how much each place of a section holds</source>
        <translation>quanto regge ogni punto di una sezione</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>la pelle</translation>
    </message>
    <message>
        <source>how parts lie on the sheets</source>
        <translation>come stanno i pezzi sulle lastre</translation>
    </message>
    <message>
        <source>what magnets make of templates</source>
        <translation>come i magneti cambiano i riferimenti</translation>
    </message>
    <message>
        <source>what frees parts that block each other</source>
        <translation>che cosa libera i pezzi che si bloccano a vicenda</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set up cutting</source>
        <translation>Imposta il taglio</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>Modifica %1</translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambia materiale di %1</translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Cambia materiale di %n sezione</numerusform>
            <numerusform>Cambia materiale di %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Inserisci %1</translation>
    </message>
    <message>
        <source>Drop to the ground</source>
        <translation>Appoggia al suolo</translation>
    </message>
    <message>
        <source>Widen the base of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Allarga la base di %1</translation>
    </message>
    <message>
        <source>Add a foot to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Aggiungi un piede a %1</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Collega %1 e %2</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <extracomment>%1 is the name of a section, %2 of the one that it comes to</extracomment>
        <translation>Sposta %1 verso %2</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>Sposta %n sezione verso %1</numerusform>
            <numerusform>Sposta %n sezioni verso %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip slits of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Inverti le fessure di %1</translation>
    </message>
    <message>
        <source>Move %1 by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>Sposta %1 di %2</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>Rendi montabile</translation>
    </message>
    <message>
        <source>Support %1 with a foot</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sostieni %1 con un piede</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Allunga %1 fino al suolo</translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>Allunga %n sezione fino al suolo</numerusform>
            <numerusform>Allunga %n sezioni fino al suolo</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>Porta %1 a uno spessore di %2</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ruota %1 a 90°</translation>
    </message>
    <message>
        <source>Make %1 wider where it is weak</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Allarga %1 dove è debole</translation>
    </message>
    <message>
        <source>%1 · %2: flip the slits</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: inverti le fessure</translation>
    </message>
    <message>
        <source>%1 · %2: meeting point → %3&#x202f;%</source>
        <extracomment>%1 and %2 are the names of two sections, %3 a number</extracomment>
        <translation>%1 · %2: punto d’incontro → %3&#x202f;%</translation>
    </message>
    <message>
        <source>%1 · %2: restore automatic settings</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: ripristina le impostazioni automatiche</translation>
    </message>
    <message>
        <source>%1 · %2: kind → cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → a croce</translation>
    </message>
    <message>
        <source>%1 · %2: kind → extended cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → a croce prolungato</translation>
    </message>
    <message>
        <source>%1 · %2: kind → mortise</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → mortasa</translation>
    </message>
    <message>
        <source>%1 · %2: kind → tabs</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → linguette</translation>
    </message>
    <message>
        <source>%1 · %2: kind → none</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2: tipo → nessuno</translation>
    </message>
    <message>
        <source>Trim %1 to %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>Accorcia %1 fino a %2</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ridisegna %1</translation>
    </message>
    <message>
        <source>Draw a hole in %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Disegna un foro in %1</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Disegna %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Importa %1</translation>
    </message>
    <message>
        <source>Trace %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Ricalca %1</translation>
    </message>
    <message>
        <source>Change shape of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambia forma di %1</translation>
    </message>
    <message>
        <source>Put %1 on %2</source>
        <extracomment>%1 is a mass, %2 the name of a section</extracomment>
        <translation>Metti %1 su %2</translation>
    </message>
    <message>
        <source>Move the weight on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sposta il peso su %1</translation>
    </message>
    <message>
        <source>Set weight to %1</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>Imposta il peso a %1</translation>
    </message>
    <message>
        <source>Rename weight to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Rinomina il peso in %1</translation>
    </message>
    <message>
        <source>Remove weight</source>
        <translation>Rimuovi peso</translation>
    </message>
    <message>
        <source>Push %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Spingi %1</translation>
    </message>
    <message>
        <source>Move the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sposta la spinta su %1</translation>
    </message>
    <message>
        <source>Turn the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ruota la spinta su %1</translation>
    </message>
    <message>
        <source>Set push to %1</source>
        <extracomment>%1 is a force</extracomment>
        <translation>Imposta la spinta a %1</translation>
    </message>
    <message>
        <source>Rename push to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>Rinomina la spinta in %1</translation>
    </message>
    <message>
        <source>Remove push</source>
        <translation>Rimuovi spinta</translation>
    </message>
    <message>
        <source>Spread the load on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Distribuisci il carico su %1</translation>
    </message>
    <message>
        <source>Load the copies of %1 too</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Carica anche le copie di %1</translation>
    </message>
    <message>
        <source>Keep the load off the copies of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Non caricare le copie di %1</translation>
    </message>
    <message>
        <source>Pull templates to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Attrai i riferimenti verso %1</translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>Attrai i riferimenti verso %n sezione</numerusform>
            <numerusform>Attrai i riferimenti verso %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Release templates from %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Lascia andare i riferimenti da %1</translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>Lascia andare i riferimenti da %n sezione</numerusform>
            <numerusform>Lascia andare i riferimenti da %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Metti segni su %1</translation>
    </message>
    <message>
        <source>Change mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambia segno di %1</translation>
    </message>
    <message>
        <source>Delete mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Elimina segno di %1</translation>
    </message>
    <message>
        <source>Scale the model to %1 %</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Scala il modello al %1 %</translation>
    </message>
    <message>
        <source>Make %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Fai di %1 un cerchio</translation>
    </message>
    <message>
        <source>Make %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Fai di %1 un’ellisse</translation>
    </message>
    <message>
        <source>Make the hole in %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Fai del foro in %1 un cerchio</translation>
    </message>
    <message>
        <source>Make the hole in %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Fai del foro in %1 un’ellisse</translation>
    </message>
    <message>
        <source>Straighten lines of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Raddrizza le linee di %1</translation>
    </message>
    <message>
        <source>Make corners of %1 right angles</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Metti a squadra gli angoli di %1</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Allontana %1 dal bordo</translation>
    </message>
    <message>
        <source>Add point to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Aggiungi punto a %1</translation>
    </message>
    <message>
        <source>Delete point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Elimina punto di %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>Elimina %n punto di %1</numerusform>
            <numerusform>Elimina %n punti di %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sposta maniglia di %1</translation>
    </message>
    <message>
        <source>Bend contour of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Curva contorno di %1</translation>
    </message>
    <message>
        <source>Move point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sposta punto di %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>Sposta %n punto di %1</numerusform>
            <numerusform>Sposta %n punti di %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Change point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambia punto di %1</translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>Cambia %n punto di %1</numerusform>
            <numerusform>Cambia %n punti di %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sposta %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>Sposta %n sezione</numerusform>
            <numerusform>Sposta %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Ruota %1</translation>
    </message>
    <message numerus="yes">
        <source>Turn %n sections</source>
        <translation>
            <numerusform>Ruota %n sezione</numerusform>
            <numerusform>Ruota %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Scala %1</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>Scala %n sezione</numerusform>
            <numerusform>Scala %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Copia %1</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n sections</source>
        <translation>
            <numerusform>Copia %n sezione</numerusform>
            <numerusform>Copia %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirror a copy of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Specchia una copia di %1</translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>Specchia una copia di %n sezione</numerusform>
            <numerusform>Specchia copie di %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 orthogonal</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Rendi %1 perpendicolare</translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>Rendi %n sezione perpendicolare</numerusform>
            <numerusform>Rendi %n sezioni perpendicolari</numerusform>
        </translation>
    </message>
    <message>
        <source>Align %1 to an axis</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Allinea %1 a un asse</translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>Allinea %n sezione a un asse</numerusform>
            <numerusform>Allinea %n sezioni a un asse</numerusform>
        </translation>
    </message>
    <message>
        <source>Put %1 on another section</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Metti %1 su un’altra sezione</translation>
    </message>
    <message>
        <source>Free %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Svincola %1</translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>Svincola %n sezione</numerusform>
            <numerusform>Svincola %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Attach %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Attacca %1</translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>Attacca %n sezione</numerusform>
            <numerusform>Attacca %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Change how %1 follows</source>
        <extracomment>%1 is the name of a section: how its place follows when the one that it is on is stretched</extracomment>
        <translation>Cambia il modo in cui %1 segue</translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>Cambia il modo in cui %n sezione segue</numerusform>
            <numerusform>Cambia il modo in cui %n sezioni seguono</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Blocca %1</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n sections</source>
        <translation>
            <numerusform>Blocca %n sezione</numerusform>
            <numerusform>Blocca %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Sblocca %1</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n sections</source>
        <translation>
            <numerusform>Sblocca %n sezione</numerusform>
            <numerusform>Sblocca %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Place %1 on its sheet</source>
        <extracomment>%1 is the name of a section: its part lies elsewhere on the sheet</extracomment>
        <translation>Sposta %1 sulla sua lastra</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <extracomment>%1 is the name of a section: its part stays where it lies on the sheet</extracomment>
        <translation>Fissa %1</translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>Fissa %n pezzo</numerusform>
            <numerusform>Fissa %n pezzi</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>Libera %1</translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>Libera %n sezione</numerusform>
            <numerusform>Libera %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all parts</source>
        <translation>Libera tutti i pezzi</translation>
    </message>
    <message>
        <source>Change rotation of %1</source>
        <extracomment>how parts may be turned on their sheet; %1 is the name of a section</extracomment>
        <translation>Cambia rotazione di %1</translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>Cambia rotazione di %n sezione</numerusform>
            <numerusform>Cambia rotazione di %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep %1 symmetric</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Mantieni %1 simmetrica</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>Mantieni %n sezione simmetrica</numerusform>
            <numerusform>Mantieni %n sezioni simmetriche</numerusform>
        </translation>
    </message>
    <message>
        <source>Let the halves of %1 differ</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Rendi indipendenti le metà di %1</translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>Rendi indipendenti le metà di %n sezione</numerusform>
            <numerusform>Rendi indipendenti le metà di %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Add template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Aggiungi riferimento %1</translation>
    </message>
    <message>
        <source>Remove template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Rimuovi riferimento %1</translation>
    </message>
    <message>
        <source>Change template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Cambia riferimento %1</translation>
    </message>
    <message>
        <source>Move template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sposta riferimento %1</translation>
    </message>
    <message>
        <source>Turn template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Ruota riferimento %1</translation>
    </message>
    <message>
        <source>Scale template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Scala riferimento %1</translation>
    </message>
    <message>
        <source>Align %1 and %2</source>
        <extracomment>%1 and %2 are the names of templates</extracomment>
        <translation>Allinea %1 e %2</translation>
    </message>
    <message>
        <source>Hide template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Nascondi riferimento %1</translation>
    </message>
    <message>
        <source>Show template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Mostra riferimento %1</translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Suggerisci %n sezione per %1</numerusform>
            <numerusform>Suggerisci %n sezioni per %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Make facets of %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sfaccetta %1</translation>
    </message>
    <message>
        <source>Unfold %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Sviluppa %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of an operation</extracomment>
        <translation>Aggiungi %1</translation>
    </message>
    <message>
        <source>Set %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a number</extracomment>
        <translation>Imposta %1</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <extracomment>%1 is the name a value had, %2 the one that it has now</extracomment>
        <translation>Rinomina %1 in %2</translation>
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
        <translation>Elimina %1</translation>
    </message>
    <message>
        <source>Keep the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Conserva la preimpostazione %1</translation>
    </message>
    <message>
        <source>Set to %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Imposta su %1</translation>
    </message>
    <message>
        <source>Delete the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>Elimina la preimpostazione %1</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Condividi da adattare</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Modifica il progetto</translation>
    </message>
    <message>
        <source>Set the values</source>
        <translation>Imposta i valori</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Restringi gli intervalli</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section or an operation</extracomment>
        <translation>Rinomina %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>Elimina %n sezione</numerusform>
            <numerusform>Elimina %n sezioni</numerusform>
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
        <translation>Cambia %1</translation>
    </message>
    <message>
        <source>Change the order of %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Cambia l’ordine di %1</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Ometti %1</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>Ometti %n sezione</numerusform>
            <numerusform>Ometti %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring a left-out section back</source>
        <translation>Rimetti una sezione omessa</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Taglia %1</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>Taglia %n sezione</numerusform>
            <numerusform>Taglia %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Incolla %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>Incolla %n sezione</numerusform>
            <numerusform>Incolla %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep dimension</source>
        <translation>Conserva quota</translation>
    </message>
    <message>
        <source>Delete dimension</source>
        <translation>Elimina quota</translation>
    </message>
    <message>
        <source>Make symmetric</source>
        <translation>Rendi simmetrico</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Attiva %1</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Disattiva %1</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>Converti %1</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>Stacca %1</translation>
    </message>
    <message>
        <source>Remove holes of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Rimuovi i fori di %1</translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>Rimuovi i fori di %n sezione</numerusform>
            <numerusform>Rimuovi i fori di %n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Shift planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Sposta i piani di %1</translation>
    </message>
    <message>
        <source>Change number of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Cambia il numero di piani di %1</translation>
    </message>
    <message>
        <source>Change spacing of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>Cambia la distanza dei piani di %1</translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message>
        <source>%1 is too small or too thin for sections that are %2 thick.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 è troppo piccolo o troppo sottile per sezioni spesse %2.</translation>
    </message>
    <message>
        <source>No sections of %1 were found that hold each other and stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Per %1 non sono state trovate sezioni che si tengano a vicenda e stiano in piedi.</translation>
    </message>
    <message>
        <source>No further section of %1 was found that fits among those that are there.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>Per %1 non è stata trovata un’altra sezione che stia tra quelle che ci sono.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Per %1 è stata trovata solo %n sezione: un’altra le sarebbe d’intralcio o non sarebbe tenuta da nulla.</numerusform>
            <numerusform>Per %1 sono state trovate solo %n sezioni: altre sarebbero d’intralcio o non sarebbero tenute da nulla.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%n sezione di %1 è il minimo trovato che stia in piedi.</numerusform>
            <numerusform>%n sezioni di %1 sono il minimo trovato che stia in piedi.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, so that its sections stand on a flat foot.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 è stato abbassato di %2 nel suolo, così le sue sezioni stanno su un piede piatto.</translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, and its sections have feet up to %3 high, so that they stand.</source>
        <extracomment>%1 is the name of a template, %2 and %3 are lengths</extracomment>
        <translation>%1 è stato abbassato di %2 nel suolo e le sue sezioni hanno piedi alti fino a %3, così stanno in piedi.</translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message>
        <source>It moves; only its first picture is shown.</source>
        <extracomment>of a picture</extracomment>
        <translation>È animata; viene mostrata solo la prima immagine.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n testo è stato omesso.</numerusform>
            <numerusform>%n testi sono stati omessi.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>%n immagine è stata omessa.</numerusform>
            <numerusform>%n immagini sono state omesse.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>A number, a name or a sum is missing.</source>
        <translation>Manca un numero, un nome o un calcolo.</translation>
    </message>
    <message>
        <source>An expression has no more than %1 letters; this one is longer.</source>
        <translation>Un’espressione ha al massimo %1 caratteri; questa è più lunga.</translation>
    </message>
    <message>
        <source>At “%1” the expression has more than %2 numbers, names and signs.</source>
        <extracomment>numbers, names and signs such as +</extracomment>
        <translation>Presso “%1” l’espressione ha più di %2 numeri, nomi e segni.</translation>
    </message>
    <message>
        <source>At “%1” more than %2 parentheses or signs stand in each other.</source>
        <translation>Presso “%1” ci sono più di %2 parentesi o segni uno dentro l’altro.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>“%1” qui non si può leggere.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Manca qualcosa dopo “%1”.</translation>
    </message>
    <message>
        <source>Something is missing before “%1”.</source>
        <translation>Manca qualcosa prima di “%1”.</translation>
    </message>
    <message>
        <source>Between “%1” and “%2” a sign is missing, such as + or *.</source>
        <translation>Tra “%1” e “%2” manca un segno, come + o *.</translation>
    </message>
    <message>
        <source>The parenthesis at “%1” is not closed.</source>
        <translation>La parentesi presso “%1” non è chiusa.</translation>
    </message>
    <message>
        <source>After “%1” there is one closing parenthesis too many.</source>
        <translation>Dopo “%1” c’è una parentesi chiusa di troppo.</translation>
    </message>
    <message>
        <source>The text at “%1” has no closing quote.</source>
        <translation>Al testo presso “%1” mancano le virgolette di chiusura.</translation>
    </message>
    <message>
        <source>“%1” can be one number or two: write a point, or a blank after the comma.</source>
        <translation>“%1” può essere un numero o due: scrivi un punto, o uno spazio dopo la virgola.</translation>
    </message>
    <message>
        <source>“%1” is a unit; a number belongs before it.</source>
        <translation>“%1” è un’unità; prima ci vuole un numero.</translation>
    </message>
    <message>
        <source>“%1” can be meant in two ways: put “%2” in parentheses.</source>
        <translation>“%1” si può intendere in due modi: metti “%2” tra parentesi.</translation>
    </message>
    <message>
        <source>“%1” is a second comparison; and(…; …) joins two of them.</source>
        <translation>“%1” è un secondo confronto; and(…; …) ne unisce due.</translation>
    </message>
    <message>
        <source>There is no function named “%1”.</source>
        <translation>Non c’è nessuna funzione di nome “%1”.</translation>
    </message>
    <message>
        <source>“%1” takes %2 between its parentheses, not %3.</source>
        <translation>Tra le parentesi di “%1” il numero di argomenti deve essere %2, non %3.</translation>
    </message>
    <message>
        <source>“%1” takes at least %2 between its parentheses, not %3.</source>
        <translation>Tra le parentesi di “%1” il numero di argomenti deve essere almeno %2, non %3.</translation>
    </message>
    <message>
        <source>“%1” takes at most %2 between its parentheses, not %3.</source>
        <translation>Tra le parentesi di “%1” il numero di argomenti deve essere al massimo %2, non %3.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Non c’è nessun valore di nome “%1”.</translation>
    </message>
    <message>
        <source>“%1” is the thickness of the stock; there is no single stock here.</source>
        <translation>“%1” è lo spessore del materiale; qui non c’è un unico materiale.</translation>
    </message>
    <message>
        <source>“%1” is %2, so it cannot have a unit of its own.</source>
        <translation>“%1” è %2, quindi non può avere un’unità propria.</translation>
    </message>
    <message>
        <source>“%1” is %2 and “%3” is %4; only what is alike can be added or compared.</source>
        <extracomment>%2 and %4: such as “a length”</extracomment>
        <translation>“%1” è %2 e “%3” è %4; si può sommare o confrontare solo ciò che è dello stesso genere.</translation>
    </message>
    <message>
        <source>“%1” is %2; nothing can be calculated with it.</source>
        <translation>“%1” è %2; non ci si può calcolare nulla.</translation>
    </message>
    <message>
        <source>“%1” is %2; what is needed here is %3.</source>
        <extracomment>%2 and %3: such as “a length”</extracomment>
        <translation>“%1” è %2; qui serve %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.</source>
        <translation>“%1” è %2; si può elevare solo a un piccolo numero intero, come 2, non a “%3”.</translation>
    </message>
    <message>
        <source>“%1” multiplies too many lengths, angles or masses.</source>
        <translation>“%1” moltiplica troppe lunghezze, angoli o masse.</translation>
    </message>
    <message>
        <source>“%1” is %2, which has no square root.</source>
        <translation>“%1” è %2, che non ha radice quadrata.</translation>
    </message>
    <message>
        <source>“%1” is 0, and nothing can be divided by 0.</source>
        <translation>“%1” vale 0, e per 0 non si può dividere.</translation>
    </message>
    <message>
        <source>“%1” is negative and has no square root.</source>
        <translation>“%1” è negativo e non ha radice quadrata.</translation>
    </message>
    <message>
        <source>The tangent of “%1” is infinite.</source>
        <translation>La tangente di “%1” è infinita.</translation>
    </message>
    <message>
        <source>“%1” is not between −1 and 1, so it belongs to no angle.</source>
        <translation>“%1” non è tra −1 e 1, quindi non corrisponde a nessun angolo.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>“%1” non è un numero.</translation>
    </message>
    <message>
        <source>“%1” is not above 0, and nothing can be rounded to steps of that.</source>
        <translation>“%1” non è superiore a 0, e non si può arrotondare a passi così.</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>“%1” è troppo grande.</translation>
    </message>
    <message>
        <source>“%1” is %2, not a whole number; round, floor or ceil make it one.</source>
        <extracomment>%2: a number</extracomment>
        <translation>“%1” vale %2, che non è un numero intero; round, floor o ceil lo rendono tale.</translation>
    </message>
    <message>
        <source>“%1” is %2; it has to be at least %3.</source>
        <extracomment>%2 and %3: lengths, masses, angles or numbers</extracomment>
        <translation>“%1” vale %2; deve essere almeno %3.</translation>
    </message>
    <message>
        <source>“%1” is %2; it can be at most %3.</source>
        <translation>“%1” vale %2; può essere al massimo %3.</translation>
    </message>
    <message>
        <source>“%1” is “%2”, which is none of the choices.</source>
        <translation>“%1” vale “%2”, che non è tra le scelte.</translation>
    </message>
    <message>
        <source>“%1” makes a text of more than %2 letters.</source>
        <translation>“%1” dà un testo di più di %2 caratteri.</translation>
    </message>
    <message>
        <source>This value is made of itself: %1.</source>
        <extracomment>%1: such as “a → b → a”</extracomment>
        <translation>Questo valore dipende da sé stesso: %1.</translation>
    </message>
    <message>
        <source>This value is made of “%1”, which has none at the moment.</source>
        <translation>Questo valore dipende da “%1”, che al momento non ne ha uno.</translation>
    </message>
    <message>
        <source>Two values are named “%1”.</source>
        <translation>Due valori si chiamano “%1”.</translation>
    </message>
    <message>
        <source>“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.</source>
        <translation>“%1” non è un nome; un nome è una lettera seguita da lettere, cifre e _, al massimo %2.</translation>
    </message>
    <message>
        <source>“%1” cannot be a name, as it means something in expressions.</source>
        <translation>“%1” non può essere un nome, perché nelle espressioni ha già un significato.</translation>
    </message>
    <message>
        <source>This value is not there any more.</source>
        <translation>Questo valore non c’è più.</translation>
    </message>
    <message>
        <source>The brace at “%1” is not closed.</source>
        <translation>La parentesi graffa presso “%1” non è chiusa.</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>un numero semplice</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un numero intero</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>una lunghezza</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>un’area</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>un volume</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un angolo</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>una massa</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un testo</translation>
    </message>
    <message>
        <source>a yes or no</source>
        <translation>un sì o no</translation>
    </message>
    <message>
        <source>no length, angle, mass or plain number</source>
        <extracomment>of what lengths, angles and masses are multiplied and divided to: “1/width” is …</extracomment>
        <translation>né lunghezza, né angolo, né massa, né numero semplice</translation>
    </message>
</context>
<context>
    <name>fff::SectionNames</name>
    <message>
        <source>Section %1</source>
        <extracomment>what the program calls a section that nobody has named; %1 is its number</extracomment>
        <translation>Sezione %1</translation>
    </message>
    <message>
        <source>Sections %1</source>
        <extracomment>several that nobody has named; %1 is such as &quot;70–73&quot; or &quot;2, 5–8&quot;</extracomment>
        <translation>Sezioni %1</translation>
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
        <translation>Non c’è nessun materiale “%1”. Scegline uno del file o dell’elenco dei materiali, per esempio Birch plywood, Acrylic o Card.</translation>
    </message>
    <message>
        <source>--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 mm.</source>
        <translation>--thickness %1 non lascia spazio alle fessure nel materiale %2: il suo gioco è %3 mm.</translation>
    </message>
    <message>
        <source>--%1 does not fit the stock %2, which is %3 mm thick.</source>
        <translation>--%1 non è adatto al materiale %2, spesso %3 mm.</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>un file %1</translation>
    </message>
    <message>
        <source>a %2 %1 file</source>
        <translation>un file %1 di %2</translation>
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
        <translation>Mostra questo aiuto.</translation>
    </message>
    <message>
        <source>No file was given.</source>
        <translation>Nessun file indicato.</translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation>Troppi file: %1</translation>
    </message>
    <message>
        <source>Gives a named value of the model another number, or all that a preset sets; may be repeated.</source>
        <translation>Dà un altro numero a un valore con nome del modello, o imposta tutto ciò che imposta una preimpostazione; si può ripetere.</translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation>Spessore di ogni materiale.</translation>
    </message>
    <message>
        <source>Cuts every section from this stock, or from that of a .fff file.</source>
        <translation>Taglia tutte le sezioni da questo materiale, o da quello di un file .fff.</translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation>Larghezza totale che la macchina asporta.</translation>
    </message>
    <message>
        <source>Play added to slits; less than 0 for a press fit.</source>
        <translation>Gioco aggiunto alle fessure; meno di 0 per un incastro a pressione.</translation>
    </message>
    <message>
        <source>Says of each thing in the file that was corrected where.</source>
        <translation>Per ogni cosa corretta nel file dice dove.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected %3.</source>
        <translation>--%1: trovato “%2”, atteso: %3.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from %3 to %4.</source>
        <translation>--%1: trovato “%2”, atteso: un numero da %3 a %4.</translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation>--sheet: trovato “%1”, atteso: larghezza x altezza in mm, per esempio 600x400.</translation>
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
        <translation>Accosta tutti i %1 listelli: ciò che manca alla loro larghezza per arrivare a %2 mm, diviso per %1, è il solco di taglio.</translation>
    </message>
    <message>
        <source>Bridges that hold each part in its sheet, and their width in mm, such as 3:0.4 (none).</source>
        <translation>Ponticelli che tengono ogni pezzo nella sua lastra e la loro larghezza in mm, per esempio 3:0.4 (nessuno).</translation>
    </message>
    <message>
        <source>Begins and ends each cut so far beside its line, in the waste (0).</source>
        <translation>Comincia e finisce ogni taglio a questa distanza dalla sua linea, nello scarto (0).</translation>
    </message>
    <message>
        <source>Cuts edges of two parts that lie on each other once; with --spacing 0.</source>
        <translation>Taglia una volta sola i bordi di due pezzi che coincidono; con --spacing 0.</translation>
    </message>
    <message>
        <source>Writes a test piece in place of the parts: slits of numbered widths, and slats that tell the kerf.</source>
        <translation>Scrive un pezzo di prova al posto dei pezzi: fessure di larghezze numerate e listelli che rivelano il solco di taglio.</translation>
    </message>
    <message>
        <source>--tabs: found &quot;%1&quot;, expected a number from 0 to %2, then a colon and a width from %3 to %4.</source>
        <translation>--tabs: trovato “%1”, atteso: un numero da 0 a %2, poi due punti e una larghezza da %3 a %4.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from 0 to %3.</source>
        <translation>--%1: trovato “%2”, atteso: un numero da 0 a %3.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Step %1: start with part %2</source>
        <translation>Passo %1: comincia con il pezzo %2</translation>
    </message>
    <message>
        <source>Step %1: start a group of its own with part %2</source>
        <translation>Passo %1: comincia un gruppo a parte con il pezzo %2</translation>
    </message>
    <message>
        <source>Step %1: part %2</source>
        <translation>Passo %1: pezzo %2</translation>
    </message>
    <message>
        <source>Step %1: parts %2 as one, joining what steps %3 and %4 have put together</source>
        <translation>Passo %1: i pezzi %2 come uno solo, unendo ciò che hanno montato i passi %3 e %4</translation>
    </message>
    <message>
        <source>Sections: %1</source>
        <translation>Sezioni: %1</translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation>Incastri: %1</translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation>%1 e %2 si incontrano, ma nessuna fessura permette di infilarle.</translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation>Tutte le sezioni restano insieme.</translation>
    </message>
    <message>
        <source>a part of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>un pezzo di %1</translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation>Non collegate al resto: %1</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation>Dimensioni %1 × %2 × %3 mm (larghezza, altezza, profondità)</translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation>Massa %1 g</translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation>Materiale %1, %2 mm, lastre da %3</translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation>Pezzo %1: %2, %3</translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation>, incastri %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no sections.</source>
        <translation>Nulla da tagliare: il modello non ha sezioni.</translation>
    </message>
    <message>
        <source>Nothing to cut: the slits leave nothing of any section.</source>
        <translation>Nulla da tagliare: le fessure non lasciano nulla di nessuna sezione.</translation>
    </message>
    <message>
        <source>-o is missing: give the file to write.</source>
        <translation>Manca -o: indica il file da scrivere.</translation>
    </message>
    <message>
        <source>-o: a file needs a name.</source>
        <translation>-o: un file ha bisogno di un nome.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected %2.</source>
        <translation>%1: questo tipo di file non si può scrivere; atteso: %2.</translation>
    </message>
    <message>
        <source>Puts a mesh, a picture or a drawing (SVG) beside the model, its largest extent of this size in mm; may be given several times.</source>
        <translation>Mette accanto al modello una mesh, un’immagine o un disegno (SVG), con questa estensione massima in mm; si può indicare più volte.</translation>
    </message>
    <message>
        <source>--template: found &quot;%1&quot;, expected a file, or a file and its size in mm, such as ball.stl@80.</source>
        <translation>--template: trovato “%1”, atteso: un file, o un file e la sua misura in mm, per esempio ball.stl@80.</translation>
    </message>
    <message>
        <source>The .fff file to write; - is standard output.</source>
        <translation>Il file .fff da scrivere; - è lo standard output.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent; without it as large as its file says, else 254.</source>
        <translation>Scala la mesh a questa estensione massima; senza, grande quanto dice il suo file, altrimenti 254.</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a whole number from %3 to %4.</source>
        <translation>--%1: trovato “%2”, atteso: un numero intero da %3 a %4.</translation>
    </message>
    <message>
        <source>%1: this item is too large for the strip.</source>
        <extracomment>%1 is a file and a place in it</extracomment>
        <translation>%1: questo elemento è troppo grande per la striscia.</translation>
    </message>
    <message>
        <source>Length: %1</source>
        <translation>Lunghezza: %1</translation>
    </message>
    <message>
        <source>Density: %1 %</source>
        <translation>Densità: %1 %</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>Pezzi: %1, lastre: %2</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3: %4 parts, %5 % covered</source>
        <extracomment>A sheet&apos;s size, its stock, how many parts lie on it, and how much of it they cover</extracomment>
        <translation>%1 × %2 mm, %3: %4 pezzi, %5 % coperto</translation>
    </message>
    <message>
        <source>%1: a part is too large for its sheet.</source>
        <translation>%1: un pezzo è troppo grande per la sua lastra.</translation>
    </message>
    <message>
        <source>--sheets: found &quot;%1&quot;, expected groups or files.</source>
        <translation>--sheets: trovato “%1”, atteso: groups o files.</translation>
    </message>
    <message>
        <source>--machine: there is no machine &quot;%1&quot;; expected %2, or a .json file.</source>
        <translation>--machine: non c’è nessuna macchina “%1”; atteso: %2, o un file .json.</translation>
    </message>
    <message>
        <source>--machine: %1</source>
        <translation>--machine: %1</translation>
    </message>
    <message>
        <source>--sheets files needs a name: standard output is one file only.</source>
        <translation>--sheets files ha bisogno di un nome: lo standard output è un solo file.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide.</source>
        <translation>Le fessure sono disegnate larghe %1 mm.</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide (%2 − %3 kerf).</source>
        <extracomment>%2 is the width that is wanted, which is larger by the kerf %3</extracomment>
        <translation>Le fessure sono disegnate larghe %1 mm (%2 − %3 di solco di taglio).</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1</source>
        <translation>Ci sono ancora lastre di un’esportazione precedente: %1</translation>
    </message>
    <message>
        <source>Patches: %1, triangles: %2.</source>
        <translation>Superfici: %1, triangoli: %2.</translation>
    </message>
    <message>
        <source>Places that stay open: %1</source>
        <translation>Zone che restano aperte: %1</translation>
    </message>
    <message>
        <source>%1: %2 m of cuts, about %3 min.</source>
        <extracomment>%1 is a machine, %2 and %3 are numbers</extracomment>
        <translation>%1: %2 m di taglio, circa %3 min.</translation>
    </message>
    <message>
        <source>Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.</source>
        <extracomment>%1 x %2 is the size of a bed</extracomment>
        <translation>Le lastre sono più grandi del piano di lavoro di %1 x %2 mm; scegline altre con --sheet.</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2, %3 % used.</source>
        <translation>Pezzi: %1, lastre: %2, %3 % utilizzato.</translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation>Il file da scrivere; - è lo standard output.</translation>
    </message>
    <message>
        <source>%1; needed if the file&apos;s name does not tell.</source>
        <translation>%1; necessario se il nome del file non lo dice.</translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation>Omette la barra da 100 mm accanto alle lastre.</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut (5).</source>
        <translation>Dal bordo della lastra al taglio più vicino (5).</translation>
    </message>
    <message>
        <source>Between neighbouring cuts (2).</source>
        <translation>Tra tagli vicini (2).</translation>
    </message>
    <message>
        <source>Quarter turns only, for sheets with a grain.</source>
        <translation>Solo quarti di giro, per lastre con una venatura.</translation>
    </message>
    <message>
        <source>Lays parts by their true outlines, searching for so many seconds; 0 takes the first layout (by their boxes).</source>
        <translation>Dispone i pezzi secondo i loro veri contorni, cercando per questi secondi; 0 usa la prima disposizione (secondo i loro rettangoli).</translation>
    </message>
    <message>
        <source>groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so on (groups).</source>
        <translation>groups: un solo SVG con un gruppo per lastra; files: OUT-1.svg, OUT-2.svg e così via (groups).</translation>
    </message>
    <message>
        <source>The machine that cuts, for its colours, speeds and G-code: %1; or a .json file with one&apos;s own (generic).</source>
        <translation>La macchina che taglia, per i suoi colori, velocità e G-code: %1; o un file .json con una propria (generic).</translation>
    </message>
    <message>
        <source>Writes the form that the sections suggest, as a surface (%1), in place of the solids.</source>
        <extracomment>%1 are ends of names, such as &quot;obj or stl&quot;</extracomment>
        <translation>Scrive la forma che le sezioni suggeriscono, come superficie (%1), al posto dei solidi.</translation>
    </message>
    <message>
        <source>With -o - the format is missing: --format %1.</source>
        <translation>Con -o - manca il formato: --format %1.</translation>
    </message>
    <message>
        <source>--skin: this kind of file cannot hold it; expected %1.</source>
        <translation>--skin: questo tipo di file non può contenerla; atteso: %1.</translation>
    </message>
    <message>
        <source>--coupon: this kind of file cannot hold it; expected %1.</source>
        <translation>--coupon: questo tipo di file non può contenerlo; atteso: %1.</translation>
    </message>
    <message>
        <source>Pixels of the picture (1280x800).</source>
        <translation>Pixel dell’immagine (1280x800).</translation>
    </message>
    <message>
        <source>iso1 to iso4, front, right, top, left, back, bottom, or fit: the front again (iso1).</source>
        <translation>da iso1 a iso4, front, right, top, left, back, bottom o fit: di nuovo il fronte (iso1).</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height in pixels up to %2, such as 1280x800.</source>
        <translation>--size: trovato “%1”, atteso: larghezza x altezza in pixel fino a %2, per esempio 1280x800.</translation>
    </message>
    <message>
        <source>--view: found &quot;%1&quot;, expected one of %2.</source>
        <translation>--view: trovato “%1”, atteso uno tra: %2.</translation>
    </message>
    <message>
        <source>Stands.</source>
        <translation>Sta in piedi.</translation>
    </message>
    <message>
        <source>Falls over.</source>
        <translation>Si ribalta.</translation>
    </message>
    <message>
        <source>Falls over: it has only a single line to stand on.</source>
        <translation>Si ribalta: poggia su una sola linea.</translation>
    </message>
    <message>
        <source>A part of it has nothing to stand on.</source>
        <translation>Una sua parte non ha nulla su cui poggiare.</translation>
    </message>
    <message>
        <source>It is not on the ground.</source>
        <translation>Non poggia sul suolo.</translation>
    </message>
    <message>
        <source>Slides away over the ground.</source>
        <translation>Scivola via sul suolo.</translation>
    </message>
    <message>
        <source>Its parts move against each other.</source>
        <translation>Le sue parti si muovono l’una rispetto all’altra.</translation>
    </message>
    <message>
        <source>Holds.</source>
        <translation>Regge.</translation>
    </message>
    <message>
        <source>Barely holds: it may crack in a corner.</source>
        <translation>Regge appena: può creparsi in un angolo.</translation>
    </message>
    <message>
        <source>Breaks.</source>
        <translation>Si rompe.</translation>
    </message>
    <message>
        <source>A joint is pulled open.</source>
        <translation>Un incastro si sfila.</translation>
    </message>
    <message>
        <source>Strength is worked out only for what stands still.</source>
        <translation>La resistenza si calcola solo per ciò che sta fermo.</translation>
    </message>
    <message>
        <source>Not rated: the strength of a stock is not known.</source>
        <translation>Non valutato: la resistenza di un materiale non è nota.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Non si è potuto calcolare se regge.</translation>
    </message>
    <message>
        <source>Would stand %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Starebbe in piedi %1.</translation>
    </message>
    <message>
        <source>Too weak: it holds, but not with the safety that is asked for.</source>
        <translation>Troppo debole: regge, ma non con la sicurezza richiesta.</translation>
    </message>
    <message>
        <source>Would hold %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>Reggerebbe %1.</translation>
    </message>
    <message>
        <source>%1 presses on the ground with %2 N.</source>
        <translation>%1 preme sul suolo con %2 N.</translation>
    </message>
    <message>
        <source>Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.</source>
        <translation>L’incastro %1–%2 si sfila con %3 N: incollalo o inverti le sue fessure.</translation>
    </message>
    <message>
        <source>How %1 bends could not be worked out; it is treated as rigid.</source>
        <translation>Non si è potuto calcolare come si flette %1; viene considerata rigida.</translation>
    </message>
    <message>
        <source>How sections bend could not be worked out; they are treated as rigid.</source>
        <translation>Non si è potuto calcolare come si flettono le sezioni; vengono considerate rigide.</translation>
    </message>
    <message>
        <source>Joints can share the load in more than one way (indeterminate, %1); the worst way counts.</source>
        <translation>Gli incastri possono dividersi il carico in più di un modo (indeterminato, %1); conta il modo peggiore.</translation>
    </message>
    <message>
        <source>The stress in %1 could not be worked out.</source>
        <translation>Impossibile calcolare la tensione in %1.</translation>
    </message>
    <message>
        <source>%1 is not rated: the strength of its stock is not known.</source>
        <translation>%1 non è valutata: la resistenza del suo materiale non è nota.</translation>
    </message>
    <message>
        <source>A push of %1 N misses the material of %2; the nearest place takes it.</source>
        <translation>Una spinta di %1 N non tocca il materiale di %2; la porta il punto più vicino.</translation>
    </message>
    <message>
        <source>A weight of %1 misses the material of %2; the nearest place takes it.</source>
        <translation>Un peso di %1 non tocca il materiale di %2; lo porta il punto più vicino.</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>%1 in tutto</translation>
    </message>
    <message>
        <source>%1 N in all</source>
        <translation>%1 N in tutto</translation>
    </message>
    <message>
        <source>%1 times the load</source>
        <translation>%1 volte il carico</translation>
    </message>
    <message>
        <source>Weakest in %1: %2 of its stock&apos;s strength in the neck, %3 in the corner.</source>
        <translation>Punto più debole in %1: %2 della resistenza del materiale nella strozzatura, %3 nell’angolo.</translation>
    </message>
    <message>
        <source>Bends %1 mm, most of all %2.</source>
        <translation>Si flette di %1 mm, soprattutto %2.</translation>
    </message>
    <message>
        <source>May crack from %1.</source>
        <translation>Può creparsi già con %1.</translation>
    </message>
    <message>
        <source>Breaks at %1.</source>
        <translation>Si rompe con %1.</translation>
    </message>
    <message>
        <source>Weighs %1 N with everything on it.</source>
        <translation>Pesa %1 N con tutto ciò che porta.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400.</source>
        <translation>trovato “%1”, atteso NOME=VALORE, per esempio width=400.</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400, or a preset: %2.</source>
        <extracomment>%2 are names of presets of values: &quot;A5 or A4&quot;</extracomment>
        <translation>trovato “%1”, atteso NOME=VALORE, per esempio width=400, o una preimpostazione: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be %2 or %3; please write one of these.</source>
        <extracomment>all are ways to write numbers: &quot;1,125&quot;, &quot;1.125&quot; and &quot;1125&quot;</extracomment>
        <translation>“%1” può essere %2 o %3; scrivi uno di questi.</translation>
    </message>
    <message>
        <source>the model has no values with names.</source>
        <translation>il modello non ha valori con un nome.</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;; expected %2.</source>
        <translation>non c’è nessun valore “%1”; atteso: %2.</translation>
    </message>
    <message>
        <source>No value that others can adjust has a range and is used.</source>
        <translation>Nessun valore regolabile da altri ha un intervallo ed è usato.</translation>
    </message>
    <message>
        <source>Tried: %1 of %2 corners of the ranges, %3 variants between them.</source>
        <translation>Provati: %1 di %2 estremi degli intervalli, %3 varianti nel mezzo.</translation>
    </message>
    <message>
        <source>All of them are good.</source>
        <translation>Vanno bene tutte.</translation>
    </message>
    <message>
        <source>%1 of %2 fail:</source>
        <translation>%1 su %2 non vanno bene:</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>Dove:</translation>
    </message>
    <message>
        <source>Faces: %1, shells: %2</source>
        <translation>Facce: %1, gusci: %2</translation>
    </message>
    <message>
        <source>The plane does not cut it.</source>
        <translation>Il piano non la taglia.</translation>
    </message>
    <message>
        <source>Hole: %1 mm², %2 points</source>
        <translation>Foro: %1 mm², %2 punti</translation>
    </message>
    <message>
        <source>Loop: %1 mm², %2 points</source>
        <translation>Curva chiusa: %1 mm², %2 punti</translation>
    </message>
    <message>
        <source>Area: %1 mm²</source>
        <translation>Area: %1 mm²</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, six numbers with commas.</source>
        <translation>Un punto del piano e la sua normale, sei numeri con virgole.</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent and stands it on the ground first.</source>
        <translation>Prima scala la mesh a questa estensione massima e la posa sul suolo.</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>Stampa JSON, per altri programmi.</translation>
    </message>
    <message>
        <source>--plane is missing.</source>
        <translation>Manca --plane.</translation>
    </message>
    <message>
        <source>--plane: found &quot;%1&quot;, expected six numbers, of which the last three are a direction.</source>
        <translation>--plane: trovato “%1”, attesi sei numeri, di cui gli ultimi tre sono una direzione.</translation>
    </message>
    <message>
        <source>No fingers where sheets meet at less than 30° or more than 150°: %1</source>
        <translation>Nessun dente dove le lastre si incontrano a meno di 30° o più di 150°: %1</translation>
    </message>
    <message>
        <source>No fingers where one sheet goes past the other or does not reach it: %1</source>
        <translation>Nessun dente dove una lastra oltrepassa l’altra o non la raggiunge: %1</translation>
    </message>
    <message>
        <source>No fingers on edges that are too short for three of them: %1</source>
        <translation>Nessun dente sui bordi troppo corti per averne tre: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>%1 and %2 are names of sections that share an edge</extracomment>
        <translation>%1 e %2</translation>
    </message>
    <message>
        <source>A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses another.</source>
        <translation>Una lastra da %1 mm non si piega, atteso al massimo %2 mm; --stock ne sceglie un’altra.</translation>
    </message>
    <message>
        <source>%1: it has %2 flat pieces, expected at most %3; --faces makes them fewer.</source>
        <translation>%1: ha %2 parti piane, attese al massimo %3; con --faces diminuiscono.</translation>
    </message>
    <message>
        <source>%1: no flat piece of it is large enough for a section; --size makes it larger.</source>
        <translation>%1: nessuna parte piana è abbastanza grande per una sezione; con --size si ingrandisce.</translation>
    </message>
    <message>
        <source>Nets: %1, folds: %2, seams: %3</source>
        <translation>Sviluppi: %1, pieghe: %2, giunzioni: %3</translation>
    </message>
    <message>
        <source>Simplifies the mesh to this many triangles first; those that are flat together are one piece.</source>
        <translation>Prima semplifica la mesh a questo numero di triangoli; quelli che giacciono su uno stesso piano sono una sola parte.</translation>
    </message>
    <message>
        <source>Nets to fold along scored lines, of sheet up to 3 mm, instead of flat sheets.</source>
        <translation>Sviluppi da piegare lungo linee cordonate, da lastre fino a 3 mm, invece di lastre piane.</translation>
    </message>
    <message>
        <source>With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, else 0 mm.</source>
        <translation>Con --unfold: larghezza dei lembi da incollare; 8 mm per lastre fino a 1,5 mm, altrimenti 0 mm.</translation>
    </message>
    <message>
        <source>--flap is of --unfold.</source>
        <translation>--flap va con --unfold.</translation>
    </message>
    <message>
        <source>Pieces too small for a section: %1</source>
        <translation>Parti troppo piccole per una sezione: %1</translation>
    </message>
    <message>
        <source>Sections: %1, joints: %2</source>
        <translation>Sezioni: %1, incastri: %2</translation>
    </message>
    <message>
        <source>How long to search (10); 0 takes the first layout.</source>
        <translation>Quanto a lungo cercare (10); 0 usa la prima disposizione.</translation>
    </message>
    <message>
        <source>Another number gives another layout, the same one the same.</source>
        <translation>Un altro numero dà un’altra disposizione, lo stesso dà la stessa.</translation>
    </message>
    <message>
        <source>How parts may be turned: none, 180, 90 or free.</source>
        <translation>Come si possono ruotare i pezzi: none, 180, 90 o free.</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut.</source>
        <translation>Dal bordo della lastra al taglio più vicino.</translation>
    </message>
    <message>
        <source>Between neighbouring cuts.</source>
        <translation>Tra tagli vicini.</translation>
    </message>
    <message>
        <source>--rotations: found &quot;%1&quot;, expected none, 180, 90 or free.</source>
        <translation>--rotations: trovato “%1”, atteso: none, 180, 90 o free.</translation>
    </message>
    <message>
        <source>The model has no operations.</source>
        <translation>Il modello non ha operazioni.</translation>
    </message>
    <message>
        <source>1 section</source>
        <translation>1 sezione</translation>
    </message>
    <message>
        <source>off</source>
        <translation>disattivata</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs; steps are counted from 0.</source>
        <translation>Stampa JSON, per altri programmi; i passi si contano da 0.</translation>
    </message>
    <message>
        <source>Largest distance between chords and curves (0.01).</source>
        <translation>Distanza massima tra corde e curve (0.01).</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .png.</source>
        <translation>%1: questo tipo di file non si può scrivere; atteso: .png.</translation>
    </message>
    <message>
        <source>--show: found &quot;%1&quot;, expected labels, checks, stress, forces, skin, or several separated by commas.</source>
        <translation>--show: trovato “%1”, atteso: labels, checks, stress, forces, skin, o più d’uno separati da virgole.</translation>
    </message>
    <message>
        <source>%1: no forces are shown; it does not stand, or they could not be worked out. &quot;check&quot; says why.</source>
        <translation>%1: non vengono mostrate forze; non sta in piedi, o non si sono potute calcolare. “check” dice perché.</translation>
    </message>
    <message>
        <source>The PNG file to write; - is standard output.</source>
        <translation>Il file PNG da scrivere; - è lo standard output.</translation>
    </message>
    <message>
        <source>labels: the sections&apos; names; checks: outlines sections with a problem; stress: the weakest cross-sections; forces: what feet and joints carry; skin: the form that the sections suggest.</source>
        <translation>labels: i nomi delle sezioni; checks: evidenzia le sezioni con un problema; stress: i punti più deboli; forces: ciò che portano piedi e incastri; skin: la forma che le sezioni suggeriscono.</translation>
    </message>
    <message>
        <source>Stress by finite elements, in colours all over the sections; takes seconds.</source>
        <translation>Tensione con elementi finiti, a colori su tutte le sezioni; richiede qualche secondo.</translation>
    </message>
    <message>
        <source>A picture needs a display with OpenGL 3.3; there is none.</source>
        <translation>Un’immagine richiede uno schermo con OpenGL 3.3; non ce n’è uno.</translation>
    </message>
    <message>
        <source>The picture could not be written as a PNG file.</source>
        <translation>Impossibile scrivere l’immagine come file PNG.</translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation>Il modello da cui partire; senza, uno nuovo.</translation>
    </message>
    <message>
        <source>--along: found &quot;%1&quot;, expected X, Y, Z, XY, XZ, YZ or radial.</source>
        <translation>--along: trovato “%1”, atteso: X, Y, Z, XY, XZ, YZ o radial.</translation>
    </message>
    <message>
        <source>--count and --spacing were both given; expected one of them.</source>
        <translation>Indicati sia --count sia --spacing; atteso uno solo dei due.</translation>
    </message>
    <message>
        <source>--spacing: planes around an axis have none; expected --count.</source>
        <translation>--spacing: i piani attorno a un asse non hanno distanza; atteso: --count.</translation>
    </message>
    <message>
        <source>The axes that planes are across: X, Y, Z, two of them for a grid, or radial: around the upright axis (XZ).</source>
        <translation>Gli assi a cui i piani sono perpendicolari: X, Y, Z, due di loro per una griglia, o radial: attorno all’asse verticale (XZ).</translation>
    </message>
    <message>
        <source>Planes in each direction (6).</source>
        <translation>Piani in ogni direzione (6).</translation>
    </message>
    <message>
        <source>From plane to plane.</source>
        <translation>Da piano a piano.</translation>
    </message>
    <message>
        <source>%1: no plane cuts a section of it that is large enough.</source>
        <translation>%1: nessun piano ne taglia una sezione abbastanza grande.</translation>
    </message>
    <message>
        <source>--size is for .png; a PDF has the size of its paper.</source>
        <translation>--size vale per .png; un PDF ha il formato della sua carta.</translation>
    </message>
    <message>
        <source>--paper is for .pdf.</source>
        <translation>--paper vale per .pdf.</translation>
    </message>
    <message>
        <source>--paper: found &quot;%1&quot;, expected a4 or letter.</source>
        <translation>--paper: trovato “%1”, atteso: a4 o letter.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Passo %1 di %2</translation>
    </message>
    <message>
        <source>a4 or letter (by default as is usual in your country).</source>
        <translation>a4 o letter (di norma quello usuale nel tuo paese).</translation>
    </message>
    <message>
        <source>How many sections (8).</source>
        <translation>Quante sezioni (8).</translation>
    </message>
    <message>
        <source>Another number gives other sections (1).</source>
        <translation>Un altro numero dà altre sezioni (1).</translation>
    </message>
    <message>
        <source>Presets: %1. It is set to %2.</source>
        <extracomment>%1 are names of presets of values, %2 is the one that is set</extracomment>
        <translation>Preimpostazioni: %1. È impostata %2.</translation>
    </message>
    <message>
        <source>Presets: %1</source>
        <translation>Preimpostazioni: %1</translation>
    </message>
    <message>
        <source>The model has no values with names.</source>
        <translation>Il modello non ha valori con un nome.</translation>
    </message>
    <message>
        <source>Tries the ranges of the values that others can adjust.</source>
        <translation>Prova gli intervalli dei valori regolabili da altri.</translation>
    </message>
    <message>
        <source>Another number tries other places, the same one the same.</source>
        <translation>Un altro numero prova altri punti, lo stesso prova gli stessi.</translation>
    </message>
    <message>
        <source>there are more cells than names.</source>
        <translation>ci sono più celle che nomi.</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <extracomment>%1 is a file&apos;s name, %2 the number of a line, %3 a sentence</extracomment>
        <translation>%1:%2: %3</translation>
    </message>
    <message>
        <source>A CSV file: names of values, and a line of numbers for each variant.</source>
        <translation>Un file CSV: nomi di valori e una riga di numeri per ogni variante.</translation>
    </message>
    <message>
        <source>The folder to write to; it is made where there is none.</source>
        <translation>La cartella in cui scrivere; se non c’è, viene creata.</translation>
    </message>
    <message>
        <source>What is written of each (svg).</source>
        <translation>Che cosa si scrive di ognuna (svg).</translation>
    </message>
    <message>
        <source>--table and -o are both needed.</source>
        <translation>Servono sia --table sia -o.</translation>
    </message>
    <message>
        <source>--format: found &quot;%1&quot;, expected a kind of cutting file.</source>
        <translation>--format: trovato “%1”, atteso: un tipo di file di taglio.</translation>
    </message>
    <message>
        <source>%1: found no line of numbers, expected one below the names.</source>
        <translation>%1: non trovata nessuna riga di numeri, attesa una sotto i nomi.</translation>
    </message>
    <message>
        <source>%1: a quote is not closed.</source>
        <translation>%1: una virgoletta non è chiusa.</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made.</source>
        <translation>%1: impossibile creare la cartella.</translation>
    </message>
    <message>
        <source>Puts a weight on a section, in its middle or at X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Can be repeated.</source>
        <translation>Mette un peso su una sezione, nel mezzo o in X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Si può ripetere.</translation>
    </message>
    <message>
        <source>--weight %1: expected NAME=MASS, as in &quot;Rib 4=350g&quot;.</source>
        <translation>--weight %1: atteso NOME=MASSA, per esempio &quot;Rib 4=350g&quot;.</translation>
    </message>
    <message>
        <source>--weight %1: expected a mass above 0 and up to 1000000 kg behind the =, with g, kg, oz or lb.</source>
        <translation>--weight %1: dopo il segno = è attesa una massa superiore a 0 e fino a 1000000 kg, con g, kg, oz o lb.</translation>
    </message>
    <message>
        <source>--weight %1: there is no section &quot;%2&quot;.</source>
        <translation>--weight %1: non c’è nessuna sezione “%2”.</translation>
    </message>
    <message>
        <source>--weight %1: slits leave nothing of &quot;%2&quot;.</source>
        <translation>--weight %1: le fessure non lasciano nulla di “%2”.</translation>
    </message>
    <message>
        <source>%1: two columns are named &quot;%2&quot;.</source>
        <translation>%1: due colonne si chiamano &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .pdf, .html or .png.</source>
        <translation>%1: questo tipo di file non si può scrivere; atteso: .pdf, .html o .png.</translation>
    </message>
    <message>
        <source>--size is for .png; a web page fits its screen.</source>
        <translation>--size vale per .png; una pagina web si adatta al suo schermo.</translation>
    </message>
    <message>
        <source>A picture of the steps could not be made.</source>
        <translation>Impossibile creare un’immagine dei passi.</translation>
    </message>
    <message>
        <source>A PDF file with all steps (- is standard output), OUT.html for a web page where the model can be turned, also on a phone, or OUT.png for OUT-01.png, OUT-02.png and so on.</source>
        <translation>Un file PDF con tutti i passi (- è lo standard output), OUT.html per una pagina web in cui si può girare il modello, anche su un telefono, o OUT.png per OUT-01.png, OUT-02.png e così via.</translation>
    </message>
    <message>
        <source>--offcut: so many offcuts of the stock %1 are too many.</source>
        <translation>--offcut: così tanti ritagli del materiale %1 sono troppi.</translation>
    </message>
    <message>
        <source>Sheets of %1 that are missing: %2</source>
        <extracomment>%1 is a stock, %2 a number</extracomment>
        <translation>Lastre di %1 che mancano: %2</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>I passi non sono tra i file: %1</translation>
    </message>
    <message>
        <source>Sheets of %1 have no room within margins of %2 mm.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Le lastre di %1 non hanno spazio entro margini di %2 mm.</translation>
    </message>
    <message>
        <source>--offcut: found &quot;%1&quot;, expected width x height in mm, such as 300x200, or an .svg file, and behind them how many there are, such as :2.</source>
        <translation>--offcut: trovato &quot;%1&quot;, attesa larghezza x altezza in mm, come 300x200, o un file .svg, seguita da quanti sono, come :2.</translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400; with :N behind it, how many there are.</source>
        <translation>Misura di una lastra, come 600x400; seguita da :N, quante ce ne sono.</translation>
    </message>
    <message>
        <source>--offcut %1: the model has no stock &quot;%2&quot;; it is cut from %3.</source>
        <extracomment>%1 is what was typed, %2 the name of a stock, %3 names of stocks</extracomment>
        <translation>--offcut %1: il modello non ha il materiale &quot;%2&quot;; è tagliato da %3.</translation>
    </message>
    <message>
        <source>--offcut %1: the model is cut from %2. Say of which this one is, as in &quot;%3=%1&quot;.</source>
        <translation>--offcut %1: il modello è tagliato da %2. Indica di quale è questo, come in &quot;%3=%1&quot;.</translation>
    </message>
    <message>
        <source>A sheet of another size, or what is left of one as the largest outline of an .svg file in true size, which is used up before whole ones; with :N behind it, so many of them. Of a model of several stocks with the stock&apos;s name in front: &quot;Birch plywood=300x200&quot;. May be repeated.</source>
        <translation>Una lastra di un’altra misura, o ciò che ne resta come la sagoma più grande di un file .svg in scala reale, che si consuma prima di quelle intere; con :N dietro, altrettante. In un modello di più materiali, con il nome del materiale davanti: &quot;Birch plywood=300x200&quot;. Si può ripetere.</translation>
    </message>
    <message>
        <source>Leaves only walls of this width along the contours, and where others cross.</source>
        <translation>Lascia solo pareti di questa larghezza lungo i contorni e dove altre incrociano.</translation>
    </message>
    <message>
        <source>Engraves the numbers of each joint in a colour of its own, the same on both parts.</source>
        <translation>Incide i numeri di ogni incastro in un colore proprio, lo stesso su entrambi i pezzi.</translation>
    </message>
    <message>
        <source>--joint-colours: this kind of file cannot hold them; expected %1.</source>
        <translation>--joint-colours: questo tipo di file non può contenerli; atteso %1.</translation>
    </message>
    <message>
        <source>Cut once for two parts: %1 mm.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Tagliato una volta sola per due pezzi: %1 mm.</translation>
    </message>
    <message>
        <source>No edges of two parts lie on each other: nothing is cut once. With --spacing 0 straight edges can.</source>
        <translation>Nessun bordo di due pezzi coincide: niente è tagliato una volta sola. Con --spacing 0 i bordi dritti possono coincidere.</translation>
    </message>
    <message>
        <source>Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the stock the clearance of the one that fits.</source>
        <translation>Le fessure da %1 a %2 hanno giochi da %3 a %4 mm: infila la striscia e dai al materiale il gioco di quella che va bene.</translation>
    </message>
    <message>
        <source>No room for the leads of all cuts: %1</source>
        <translation>Non c’è spazio per gli attacchi e le uscite di tutti i tagli: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::AboutDialog</name>
    <message>
        <source>About FlatFitFab</source>
        <translation>Informazioni su FlatFitFab</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>Licenze</translation>
    </message>
    <message>
        <source>For bug reports</source>
        <translation>Per segnalare errori</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>FlatFitFab %1</source>
        <translation>FlatFitFab %1</translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation>Disegna pezzi piatti in 3D, vedi subito come si incastrano e tagliali. Funziona senza account, e nulla lascia questo computer.</translation>
    </message>
    <message>
        <source>After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Ispirato a “FlatFitFab: Interactive Modeling with Planar Sections” di J. McCrae, N. Umetani e K. Singh (UIST 2014). Software libero con licenza GNU General Public License, versione 3 o successiva.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>What this program is built with</source>
        <translation>Con che cosa è fatto questo programma</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>Testo della licenza</translation>
    </message>
    <message>
        <source>This program</source>
        <translation>Questo programma</translation>
    </message>
    <message>
        <source>Windows, files and text</source>
        <translation>Finestre, file e testo</translation>
    </message>
    <message>
        <source>Exact geometry</source>
        <translation>Geometria esatta</translation>
    </message>
    <message>
        <source>Vectors and matrices</source>
        <translation>Vettori e matrici</translation>
    </message>
    <message>
        <source>Cutting and offsetting outlines</source>
        <translation>Taglio e scostamento dei contorni</translation>
    </message>
    <message>
        <source>Reading drawings</source>
        <translation>Lettura dei disegni</translation>
    </message>
    <message>
        <source>Unpacking drawings</source>
        <translation>Decompressione dei disegni</translation>
    </message>
    <message>
        <source>Models with pictures and meshes</source>
        <translation>Modelli con immagini e mesh</translation>
    </message>
    <message>
        <source>Parts that CGAL uses</source>
        <translation>Parti usate da CGAL</translation>
    </message>
    <message>
        <source>Numbers without rounding</source>
        <translation>Numeri senza arrotondamento</translation>
    </message>
    <message>
        <source>Numbers with many digits</source>
        <translation>Numeri con molte cifre</translation>
    </message>
    <message>
        <source>Results that may be errors</source>
        <translation>Risultati che possono essere errori</translation>
    </message>
    <message>
        <source>The model in web pages of the steps</source>
        <translation>Il modello nelle pagine web dei passi</translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>&amp;File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Modifica</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>Sezione</translation>
    </message>
    <message>
        <source>&amp;Operation</source>
        <translation>Operazione</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>Controlli</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aiuto</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Guarda da</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Pannelli</translation>
    </message>
    <message>
        <source>Draw on a p&amp;lane</source>
        <translation>Disegna su un piano</translation>
    </message>
    <message>
        <source>Dra&amp;w on it</source>
        <translation>Disegnaci sopra</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>Disponi</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Seleziona</translation>
    </message>
</context>
<context>
    <name>fff::ui::AdjustBar</name>
    <message>
        <source>Tool bar for adjusting</source>
        <translation>Barra degli strumenti per adattare</translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message>
        <source>just now</source>
        <translation>proprio ora</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n minuto fa</numerusform>
            <numerusform>%n minuti fa</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n ora fa</numerusform>
            <numerusform>%n ore fa</numerusform>
        </translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>ieri</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>%n giorno fa</numerusform>
            <numerusform>%n giorni fa</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Badge</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Non aggiornato</translation>
    </message>
    <message>
        <source>%1: older than the drawing</source>
        <translation>%1: non aggiornato</translation>
    </message>
</context>
<context>
    <name>fff::ui::Badges</name>
    <message>
        <source>Verdicts</source>
        <translation>Esiti</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingMarks</name>
    <message>
        <source>Holds</source>
        <translation>Regge</translation>
    </message>
    <message>
        <source>Without bending</source>
        <translation>Senza flessione</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingPicture</name>
    <message>
        <source>The section is not there</source>
        <translation>La sezione non c’è</translation>
    </message>
    <message>
        <source>It does not stand as it is</source>
        <translation>Così com’è non sta in piedi</translation>
    </message>
    <message>
        <source>It breaks as it is</source>
        <translation>Così com’è si rompe</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Resistenza sconosciuta</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>calcolo… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>calcolo…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>fermato</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>impossibile da calcolare</translation>
    </message>
</context>
<context>
    <name>fff::ui::CanvasBar</name>
    <message>
        <source>Numbers of the drawing tool</source>
        <translation>Numeri dello strumento di disegno</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanza</translation>
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
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Su</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>away from its plane</extracomment>
        <translation>Fuori</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copie</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckRow</name>
    <message>
        <source>Older than the drawing</source>
        <translation>Non aggiornato</translation>
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
        <translation>A posto</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Sconosciuto</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avviso</translation>
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
            <numerusform>%1 in %n punto</numerusform>
            <numerusform>%1 in %n punti</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>%1 of %2 places, and the sentence about that one</extracomment>
        <translation>%1 di %2: %3</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Controlli</translation>
    </message>
    <message>
        <source>Checks begin with the first section.</source>
        <translation>I controlli cominciano con la prima sezione.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ferma</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Controllo in corso…</translation>
    </message>
    <message>
        <source>Older than the drawing</source>
        <translation>Non aggiornato</translation>
    </message>
    <message>
        <source>There is no section to check yet.</source>
        <translation>Non c’è ancora nessuna sezione da controllare.</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Nessun problema.</translation>
    </message>
    <message>
        <source>Still checking; no problems so far.</source>
        <translation>Controllo ancora in corso; finora nessun problema.</translation>
    </message>
    <message>
        <source>Problem %1 of %2: %3.</source>
        <translation>Problema %1 di %2: %3.</translation>
    </message>
    <message>
        <source>Still checking. This will be done as soon as the result is known.</source>
        <translation>Controllo ancora in corso. Verrà fatto appena si conosce il risultato.</translation>
    </message>
    <message>
        <source>The model has changed; this can no longer be done.</source>
        <translation>Il modello è cambiato; non si può più fare.</translation>
    </message>
    <message>
        <source>Done: %1.</source>
        <extracomment>%1 is what a link did, as it was said before: &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Fatto: %1.</translation>
    </message>
    <message>
        <source>If you click: %1.</source>
        <extracomment>%1 is what a link would do, such as &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>Con un clic: %1.</translation>
    </message>
    <message>
        <source>Problem %1 of %2, place %3 of %4: %5.</source>
        <translation>Problema %1 di %2, punto %3 di %4: %5.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChosenPlace</name>
    <message>
        <source>Export to</source>
        <translation>Esporta in</translation>
    </message>
</context>
<context>
    <name>fff::ui::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>Trova un comando</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Scrivi che cosa vuoi fare</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Comandi trovati</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>why</comment>
        <extracomment>where an action is in the menus, and why it cannot be done now</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Nessun comando trovato</translation>
    </message>
    <message>
        <source>Try another word</source>
        <translation>Prova con un’altra parola</translation>
    </message>
</context>
<context>
    <name>fff::ui::CouponExport</name>
    <message>
        <source>Write a fit coupon</source>
        <translation>Scrivi un provino d’incastro</translation>
    </message>
    <message>
        <source>%1 coupon</source>
        <extracomment>%1 is a model&apos;s name: what the file of its test piece is called</extracomment>
        <translation>%1 provino</translation>
    </message>
    <message>
        <source>Wrote a fit coupon to %1. Cut it and push the strip into its slits; Export asks which one fitted.</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>Provino scritto in %1. Taglialo e infila la striscia nelle sue fessure; Esporta ti chiede quale va bene.</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutRows</name>
    <message>
        <source>%1: no clearance</source>
        <extracomment>%1 is the number of a slit</extracomment>
        <translation>%1: nessun gioco</translation>
    </message>
    <message>
        <source>%1: %2 narrower</source>
        <extracomment>%1 is the number of a slit, %2 a length</extracomment>
        <translation>%1: più stretta di %2</translation>
    </message>
    <message>
        <source>%1: %2 wider</source>
        <translation>%1: più larga di %2</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>Ponticelli</translation>
    </message>
    <message>
        <source>So many short gaps in each part&apos;s cut hold it in its sheet; 0: none</source>
        <translation>Tante brevi interruzioni nel taglio di ogni pezzo lo tengono nella sua lastra; 0: nessuna</translation>
    </message>
    <message>
        <source>Width of bridges</source>
        <translation>Larghezza ponticelli</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Attacco dei tagli</translation>
    </message>
    <message>
        <source>Each cut begins and ends so far beside its line, in the waste; 0: on the line</source>
        <translation>Ogni taglio comincia e finisce a questa distanza dalla sua linea, nello scarto; 0: sulla linea</translation>
    </message>
    <message>
        <source>cut once</source>
        <translation>un solo taglio</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>Bordi in comune</translation>
    </message>
    <message>
        <source>Of parts that lie against each other, where the spacing is 0</source>
        <translation>Di pezzi accostati, dove la distanza è 0</translation>
    </message>
    <message>
        <source>Which of the numbered slits of a fit coupon holds the sheet best (cut one: menu File, or among the files for the workshop). It sets the clearance.</source>
        <translation>Quale delle fessure numerate di un provino d’incastro tiene meglio la lastra (da tagliare: menu File, o tra i file per il laboratorio). Imposta il gioco.</translation>
    </message>
    <message>
        <source>Slit that fitted</source>
        <translation>Fessura giusta</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>circa %n min</numerusform>
            <numerusform>circa %n min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::DimensionGroup</name>
    <message>
        <source>Dimensions</source>
        <translation>Quote</translation>
    </message>
    <message>
        <source>Dimension %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Quota %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is the name of a section, %2 a number</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Changing this length scales the whole model</source>
        <translation>Cambiando questa lunghezza si scala tutto il modello</translation>
    </message>
    <message>
        <source>Changing this length stretches %1 between the two places</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Cambiando questa lunghezza si allunga %1 tra i due punti</translation>
    </message>
    <message>
        <source>Delete this dimension</source>
        <translation>Elimina questa quota</translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation>Apri un modello</translation>
    </message>
    <message>
        <source>Insert a model</source>
        <translation>Inserisci un modello</translation>
    </message>
    <message>
        <source>Import a drawing</source>
        <translation>Importa un disegno</translation>
    </message>
    <message>
        <source>Add a template</source>
        <translation>Aggiungi un riferimento</translation>
    </message>
    <message>
        <source>Nothing inserted: %1 has no sections.</source>
        <translation>Nulla di inserito: %1 non ha sezioni.</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Salva il modello</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifiche non salvate</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Salvare le modifiche a %1?</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>Se non salvi, vanno perse.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salva</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>Non salvare</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>Torna alla versione salvata</translation>
    </message>
    <message>
        <source>%1 is as it was saved. Undo brings your changes back.</source>
        <translation>%1 è com’era stato salvato. Con Annulla le tue modifiche ritornano.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>Apertura di %1…</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Scegli un altro file</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Togli dall’elenco</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Salvataggio di %1…</translation>
    </message>
    <message>
        <source>Save somewhere else…</source>
        <translation>Salva altrove…</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Salvato in %1.</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Modificato su disco</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 è stato modificato da un altro programma.</translation>
    </message>
    <message>
        <source>Overwriting it would lose those changes.</source>
        <translation>Sovrascrivendolo, quelle modifiche andrebbero perse.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Salva con nome…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Sovrascrivi</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>senza nome</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingGroup</name>
    <message>
        <source>Drawing</source>
        <translation>Disegno</translation>
    </message>
    <message>
        <source>Local symmetry</source>
        <translation>Simmetria locale</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it. Shift does the opposite while you draw.</source>
        <translation>Specchia un contorno rispetto alla sua fessura quando lo disegni su un solo lato. Maiusc mentre disegni fa il contrario.</translation>
    </message>
    <message>
        <source>Mirror the first</source>
        <translation>Specchia la prima</translation>
    </message>
    <message>
        <source>Mirror the first section too, across the vertical through its start</source>
        <translation>Specchia anche la prima sezione, rispetto alla verticale per il suo inizio</translation>
    </message>
    <message>
        <source>Cut at ground</source>
        <translation>Taglia al suolo</translation>
    </message>
    <message>
        <source>Cut flat at the ground: leave out what is drawn below it</source>
        <translation>Taglia a filo del suolo: ometti ciò che disegni più in basso</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Aggancio</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines, ground and grid</source>
        <translation>Aggancia a punti, linee di allineamento, suolo e griglia</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>La vista ruota di</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane; with less, the section that you started on stays visible</source>
        <translation>A 90° guardi dritto sul nuovo piano; con meno resta visibile la sezione da cui hai iniziato</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Durata rotazione</translation>
    </message>
    <message>
        <source>How long the view takes to turn to the plane of a new section</source>
        <translation>Quanto impiega la vista a ruotare verso il piano di una nuova sezione</translation>
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
        <translation>Un foro, mentre lo disegni</translation>
    </message>
    <message>
        <source>A new contour, while you draw it</source>
        <translation>Un nuovo contorno, mentre lo disegni</translation>
    </message>
    <message>
        <source>New section, while you draw it</source>
        <translation>Nuova sezione, mentre la disegni</translation>
    </message>
    <message>
        <source>Its contour comes next</source>
        <translation>Ora tocca al contorno</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Spessore</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fessura</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Su</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Its own slit</source>
        <translation>La sua fessura</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Curve pieces</source>
        <translation>Tratti di curva</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuna</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>linguette</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>chiusa</translation>
    </message>
    <message>
        <source>opens up, %1 deep</source>
        <translation>si apre in alto, profonda %1</translation>
    </message>
    <message>
        <source>opens down, %1 deep</source>
        <translation>si apre in basso, profonda %1</translation>
    </message>
    <message>
        <source>opens sideways, %1 deep</source>
        <translation>si apre di lato, profonda %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; The two halves would not meet at the slit.</source>
        <translation>&lt;b&gt;Non specchiata.&lt;/b&gt; Le due metà non si toccherebbero alla fessura.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Symmetry is off, or Shift is held.</source>
        <translation>&lt;b&gt;Non specchiata.&lt;/b&gt; Hai disegnato su un lato dell’asse: %1 da una parte, %2 dall’altra. Simmetria è disattivata o è premuto Maiusc.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Cross it by %3 or more to draw both sides yourself.</source>
        <translation>&lt;b&gt;Specchiata.&lt;/b&gt; Hai disegnato su un lato dell’asse: %1 da una parte, %2 dall’altra. Superalo di almeno %3 per disegnare tu entrambi i lati.</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>Nuova sezione</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Riferimento</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Segue</translation>
    </message>
    <message>
        <source>On the guide</source>
        <translation>Sulla guida</translation>
    </message>
    <message>
        <source>%1 % of the stroke</source>
        <extracomment>%1 is a number: of the line that somebody draws</extracomment>
        <translation>%1 % del tratto</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>Scarto massimo</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrivenField</name>
    <message>
        <source>Only one number at a time can follow a value.</source>
        <translation>Solo un numero alla volta può seguire un valore.</translation>
    </message>
    <message>
        <source>This number cannot follow a value.</source>
        <translation>Questo numero non può seguire un valore.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExceptionRows</name>
    <message>
        <source>None. Click one section to leave it out or to detach it.</source>
        <translation>Nessuna. Fai clic su una sezione per ometterla o staccarla.</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Mostra di nuovo</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>N. %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, omessa</translation>
    </message>
    <message>
        <source>%1, detached</source>
        <translation>%1, staccata</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportDialog</name>
    <message>
        <source>Export cutting files</source>
        <translation>Esporta file di taglio</translation>
    </message>
    <message>
        <source>Open the folder afterwards</source>
        <translation>Dopo, apri la cartella</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Skin over %1</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>Pelle su %1</translation>
    </message>
    <message>
        <source>%1 as solids</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1 come solidi</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how far the machine cuts</extracomment>
        <translation>%1 su %2 · %3 di taglio</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calcolo…</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Esporta comunque</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Esporta</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Disposizione…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPlaceRow</name>
    <message>
        <source>Change…</source>
        <translation>Cambia…</translation>
    </message>
    <message>
        <source>%1 and so on, in %2</source>
        <translation>%1 e seguenti, in %2</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>%1 is a file&apos;s name, or several, %2 their folder&apos;s</extracomment>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Replaces %1 in %2</source>
        <extracomment>%1 is the name of a file that is there, %2 its folder&apos;s</extracomment>
        <translation>Sostituisce %1 in %2</translation>
    </message>
    <message>
        <source>your home folder</source>
        <translation>cartella personale</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPreview</name>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Lastra %1 di %2</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>Elenco pezzi</translation>
    </message>
    <message>
        <source>Previous sheet (Page Up)</source>
        <translation>Lastra precedente (Pag su)</translation>
    </message>
    <message>
        <source>Next sheet (Page Down)</source>
        <translation>Lastra successiva (Pag giù)</translation>
    </message>
    <message>
        <source>Show the whole sheet</source>
        <translation>Mostra tutta la lastra</translation>
    </message>
    <message>
        <source>A skin has no sheets: the file holds the form that the sections suggest, as a surface over their contours.</source>
        <translation>Una pelle non ha lastre: il file contiene la forma che le sezioni suggeriscono, come superficie sopra i loro contorni.</translation>
    </message>
    <message>
        <source>Solids have no sheets: the file holds the model as it stands, true to size, with its slits.</source>
        <translation>I solidi non hanno lastre: il file contiene il modello com’è, in scala reale, con le sue fessure.</translation>
    </message>
    <message>
        <source>Sheet %1 · %2 · %3</source>
        <extracomment>%1 is the number of a sheet, %2 the name of a stock, %3 the sheet&apos;s size</extracomment>
        <translation>Lastra %1 · %2 · %3</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Non c’è nulla da tagliare.</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Calcolo…</translation>
    </message>
    <message>
        <source>Used: %1</source>
        <extracomment>%1 is a number with a percent sign</extracomment>
        <translation>Utilizzo: %1</translation>
    </message>
    <message>
        <source>Laying the parts on sheets…</source>
        <translation>Dispongo i pezzi sulle lastre…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message>
        <source>Which stock?</source>
        <translation>Quale materiale?</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Misura di nuovo</translation>
    </message>
    <message>
        <source>Measured thickness</source>
        <translation>Spessore misurato</translation>
    </message>
    <message>
        <source>Measure the sheet that you will cut with calipers: slits are drawn to fit it.</source>
        <translation>Misura con un calibro la lastra che taglierai: le fessure vengono disegnate su misura.</translation>
    </message>
    <message>
        <source>Which sheet?</source>
        <translation>Quale lastra?</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Larghezza della lastra</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Altezza della lastra</translation>
    </message>
    <message>
        <source>%1, %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 its thickness</extracomment>
        <translation>%1, spesso %2</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Altro formato</translation>
    </message>
    <message>
        <source>Which machine?</source>
        <translation>Quale macchina?</translation>
    </message>
    <message>
        <source>Colours, layers, speeds and G-code as this machine and its program take them, and what it removes of each stock</source>
        <translation>Colori, livelli, velocità e G-code come li vogliono questa macchina e il suo programma, e quanto toglie da ogni materiale</translation>
    </message>
    <message>
        <source>%1, measured %2</source>
        <translation>%1, misurato %2</translation>
    </message>
    <message>
        <source>That is what I measured</source>
        <translation>È quello che ho misurato</translation>
    </message>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>Prima si usa %n ritaglio.</numerusform>
            <numerusform>Prima si usano %n ritagli.</numerusform>
        </translation>
    </message>
    <message>
        <source>Any laser</source>
        <translation>Un laser qualsiasi</translation>
    </message>
    <message>
        <source>No part lies on an offcut.</source>
        <translation>Nessun pezzo sta su un ritaglio.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>Prima si usa %1 ritaglio su %n.</numerusform>
            <numerusform>Prima si usano %1 ritagli su %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRemarks</name>
    <message>
        <source>%1, %2 times</source>
        <extracomment>%1 is a verdict, %2 how often it is so, two at least</extracomment>
        <translation>%1, %2 volte</translation>
    </message>
    <message>
        <source>Cannot be cut</source>
        <translation>Non si può tagliare</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Controllo in corso…</translation>
    </message>
    <message>
        <source>Nothing to look out for.</source>
        <translation>Nulla a cui badare.</translation>
    </message>
    <message>
        <source>A sheet of %1 has no room within margins of %2.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>Una lastra di %1 non ha spazio entro margini di %2.</translation>
    </message>
    <message>
        <source>The kerf width of %1 is 0: slits become wider, and parts smaller, by what the machine removes.</source>
        <extracomment>%1 is a stock</extracomment>
        <translation>Il solco di taglio di %1 è 0: le fessure vengono più larghe e i pezzi più piccoli di quanto la macchina asporta.</translation>
    </message>
    <message>
        <source>Sheets are larger than the bed of %1, which is %2. Choose smaller ones.</source>
        <extracomment>%1 is a machine, %2 the size of its bed</extracomment>
        <translation>Le lastre sono più grandi del piano di %1, che misura %2. Scegline di più piccole.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRows</name>
    <message>
        <source>Fit</source>
        <translation>Accoppiamento</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Solco di taglio (intero)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Gioco fessure</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Fessura disegnata</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposizione</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>Margin at the edge</source>
        <translation>Margine al bordo</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>Quarter turns for a sheet with a grain</source>
        <translation>Quarti di giro per una lastra con la venatura</translation>
    </message>
    <message>
        <source>100 mm, below the sheets</source>
        <translation>100 mm, sotto le lastre</translation>
    </message>
    <message>
        <source>Measuring bar</source>
        <translation>Barra di misura</translation>
    </message>
    <message>
        <source>Drawn beside the sheets, not cut: measure it on your machine to check the size</source>
        <translation>Disegnata accanto alle lastre, non tagliata: misurala sulla tua macchina per verificare la scala</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Tagli</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>Qualsiasi angolo</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Quarti di giro</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>Mezzi giri</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>Come disegnato</translation>
    </message>
    <message>
        <source>Kept for this stock and the machine that is chosen</source>
        <translation>Conservato per questo materiale e la macchina scelta</translation>
    </message>
    <message>
        <source>a colour for each joint</source>
        <translation>un colore per incastro</translation>
    </message>
    <message>
        <source>Joint numbers</source>
        <translation>Numeri degli incastri</translation>
    </message>
    <message>
        <source>The two parts of a joint have its number in the same colour: for paper, and for machines that are told what to do with each colour</source>
        <translation>I due pezzi di un incastro ne portano il numero nello stesso colore: per la carta, e per le macchine a cui si dice che cosa fare di ogni colore</translation>
    </message>
    <message>
        <source>Not sure? Cut a fit coupon first…</source>
        <translation>In dubbio? Taglia prima un provino…</translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message>
        <source>The slits of %1 leave nothing of it. It is not cut.</source>
        <translation>Le fessure non lasciano nulla di %1. Non viene tagliata.</translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation>%1 è più grande della lastra. Sta su una lastra della sua misura.</translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation>%1 è troppo sottile per portare il suo numero.</translation>
    </message>
    <message>
        <source>%1 has a hole or a notch that is narrower than the kerf and is not cut.</source>
        <translation>%1 ha un foro o una tacca più stretti del solco di taglio, che non vengono tagliati.</translation>
    </message>
    <message>
        <source>%1 has no room for the numbers of all its joints.</source>
        <translation>%1 non ha spazio per i numeri di tutti i suoi incastri.</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n pezzo</numerusform>
            <numerusform>%n pezzi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>%n lastra</numerusform>
            <numerusform>%n lastre</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sezione</numerusform>
            <numerusform>%n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Esportazione di %1…</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation>Esportato in %3: %1 su %2.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide.</source>
        <translation>Esportato in %3: %1 su %2; le fessure sono disegnate larghe %4.</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).</source>
        <translation>Esportato in %3: %1 su %2; le fessure sono disegnate larghe %4 (%5 − %6 di solco di taglio).</translation>
    </message>
    <message>
        <source>Exported %1 as solids to %2.</source>
        <translation>Esportato in %2: %1 come solidi.</translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>Pelle esportata in %1; %n zona resta aperta.</numerusform>
            <numerusform>Pelle esportata in %1; %n zone restano aperte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported the skin to %1.</source>
        <translation>Pelle esportata in %1.</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materiali…</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Esporta altrove…</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1.</source>
        <translation>Ci sono ancora lastre di un’esportazione precedente: %1.</translation>
    </message>
    <message>
        <source>Not exported: the files that are there stay.</source>
        <translation>Non esportato: i file che ci sono restano.</translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>Serve %n lastra di %1 in più di quante ce ne sono.</numerusform>
            <numerusform>Servono %n lastre di %1 in più di quante ce ne sono.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExpressionText</name>
    <message>
        <source>A number is missing.</source>
        <translation>Manca un numero.</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>“%1” qui non si può leggere.</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>Manca qualcosa dopo “%1”.</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Una parentesi non è chiusa.</translation>
    </message>
    <message>
        <source>There is one closing parenthesis too many.</source>
        <translation>C’è una parentesi chiusa di troppo.</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>Per 0 non si può dividere.</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>Non c’è nessun valore di nome “%1”.</translation>
    </message>
    <message>
        <source>This is not a length; multiply a length by a plain number.</source>
        <translation>Questa non è una lunghezza; moltiplica una lunghezza per un numero semplice.</translation>
    </message>
    <message>
        <source>This is not a mass; multiply a mass by a plain number.</source>
        <translation>Questa non è una massa; moltiplica una massa per un numero semplice.</translation>
    </message>
    <message>
        <source>“t” is the thickness of the stock; there is no single stock here.</source>
        <translation>“t” è lo spessore del materiale; qui non c’è un unico materiale.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Failures</name>
    <message>
        <source>line %1</source>
        <translation>riga %1</translation>
    </message>
    <message>
        <source>%2’s %1</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 e %2</translation>
    </message>
    <message>
        <source>Nothing was opened: no file was named.</source>
        <translation>Nulla è stato aperto: nessun file indicato.</translation>
    </message>
    <message>
        <source>%1 is not a model. FlatFitFab opens %2.</source>
        <translation>%1 non è un modello. FlatFitFab apre %2.</translation>
    </message>
    <message>
        <source>%1 could not be opened: it is not in %2 any more. Nothing was changed.</source>
        <translation>Impossibile aprire %1: non è più in %2. Nulla è cambiato.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. Nothing was changed.</source>
        <translation>Impossibile aprire %1: %2. Nulla è cambiato.</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2 (%3). Nothing was changed.</source>
        <extracomment>%3 is a place in the file, such as &quot;line 340&quot;</extracomment>
        <translation>Impossibile aprire %1: %2 (%3). Nulla è cambiato.</translation>
    </message>
    <message>
        <source>The file on disk is still the old one.</source>
        <translation>Il file su disco è ancora quello vecchio.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Nulla è stato scritto.</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>la cartella %1 non esiste</translation>
    </message>
    <message>
        <source>Not exported: %1. %2</source>
        <extracomment>%1 the reason, %2 a sentence</extracomment>
        <translation>Non esportato: %1. %2</translation>
    </message>
    <message>
        <source>Could not save %1: %2. %3</source>
        <extracomment>%1 a file&apos;s name, %2 the reason, %3 a sentence</extracomment>
        <translation>Impossibile salvare %1: %2. %3</translation>
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
        <translation>Diventa così spostando uno dei suoi punti</translation>
    </message>
    <message>
        <source>Its centre, in the coordinates of the section</source>
        <translation>Il suo centro, nelle coordinate della sezione</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Ruotato di</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Foro %1</translation>
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
        <translation>Forma libera</translation>
    </message>
</context>
<context>
    <name>fff::ui::FileQuestion</name>
    <message>
        <source>Cutting file</source>
        <translation>File di taglio</translation>
    </message>
    <message>
        <source>Paper or picture</source>
        <translation>Carta o immagine</translation>
    </message>
    <message>
        <source>Solids to print or render</source>
        <translation>Solidi da stampare o renderizzare</translation>
    </message>
    <message>
        <source>List of parts</source>
        <translation>Elenco dei pezzi</translation>
    </message>
    <message>
        <source>Everything for a workshop</source>
        <translation>Tutto per un laboratorio</translation>
    </message>
    <message>
        <source>Which file?</source>
        <translation>Quale file?</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>A che cosa serve?</translation>
    </message>
    <message>
        <source>A file for each sheet</source>
        <translation>Un file per ogni lastra</translation>
    </message>
</context>
<context>
    <name>fff::ui::FlatGroup</name>
    <message>
        <source>Trace</source>
        <translation>Ricalco</translation>
    </message>
    <message>
        <source>Lies on</source>
        <translation>Sta su</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Suolo</translation>
    </message>
    <message>
        <source>Lay it on the ground</source>
        <translation>Stendilo sul suolo</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Fronte</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the front</source>
        <translation>Mettilo in piedi, da vedere di fronte</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lato</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the right</source>
        <translation>Mettilo in piedi, da vedere da destra</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Sezione</translation>
    </message>
    <message>
        <source>Lay it on the selected section, with which it goes</source>
        <translation>Stendilo sulla sezione selezionata, con cui si sposta</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Capovolgi</translation>
    </message>
    <message>
        <source>As seen from behind</source>
        <translation>Come visto da dietro</translation>
    </message>
    <message>
        <source>Align two</source>
        <translation>Allinea due</translation>
    </message>
    <message>
        <source>The last two pictures as front and side of the same thing: as high as each other, and above the same place</source>
        <translation>Le ultime due immagini come fronte e lato della stessa cosa: alte uguali e sopra lo stesso punto</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Soglia</translation>
    </message>
    <message>
        <source>How dark it has to be to be traced</source>
        <translation>Quanto deve essere scuro per essere ricalcato</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lisciatura</translation>
    </message>
    <message>
        <source>How round corners become</source>
        <translation>Quanto si arrotondano gli angoli</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Sagome</translation>
    </message>
    <message>
        <source>Make sections</source>
        <translation>Crea sezioni</translation>
    </message>
    <message>
        <source>Sections of its outlines, on its own plane</source>
        <translation>Sezioni dalle sue sagome, sul suo piano</translation>
    </message>
    <message>
        <source>Cut holes</source>
        <translation>Taglia fori</translation>
    </message>
    <message>
        <source>Holes in the section that it lies on, or that is selected</source>
        <translation>Fori nella sezione su cui sta o che è selezionata</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>Incidi</translation>
    </message>
    <message>
        <source>Lines on the section that it lies on, or that is selected</source>
        <translation>Linee sulla sezione su cui sta o che è selezionata</translation>
    </message>
    <message>
        <source>%1: too many for sections</source>
        <extracomment>%1 is a number of outlines</extracomment>
        <translation>%1: troppe per farne sezioni</translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message>
        <source>pulled open, %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>si sfila, %1&#x202f;N</translation>
    </message>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>%n incastro si sfila, fino a %1&#x202f;N</numerusform>
            <numerusform>%n incastri si sfilano, fino a %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::FormatFilters</name>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <extracomment>%1 are patterns such as &quot;*.fff *.txt&quot;</extracomment>
        <translation>Modelli (%1)</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Disegni (%1)</translation>
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
        <translation>Destra</translation>
    </message>
    <message>
        <source>Up</source>
        <extracomment>the way up, along an arrow</extracomment>
        <translation>Su</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>the way out of the plane, towards whoever looks, along an arrow</extracomment>
        <translation>Fuori</translation>
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
        <translation>Tasti</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Aiuto</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pagine</translation>
    </message>
    <message>
        <source>Save the keys as a page</source>
        <translation>Salva i tasti su una pagina</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documenti PDF (*.pdf)</translation>
    </message>
    <message>
        <source>FlatFitFab keys</source>
        <translation>Tasti di FlatFitFab</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>Impossibile scrivere %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>Cronologia</translation>
    </message>
    <message>
        <source>Every step; choosing one goes back to it.</source>
        <translation>Tutti i passi; scegliendone uno si torna a quello.</translation>
    </message>
    <message>
        <source>Every step will be listed here; go back to any of them.</source>
        <translation>Qui comparirà ogni passo; puoi tornare a uno qualsiasi.</translation>
    </message>
    <message>
        <source>Back to the beginning. Click a later step to do it again.</source>
        <translation>Di nuovo all’inizio. Fai clic su un passo successivo per rifarlo.</translation>
    </message>
    <message>
        <source>The model is as it was after “%1”.</source>
        <translation>Il modello è com’era dopo “%1”.</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Com’era all’apertura</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>Nuovo modello</translation>
    </message>
    <message>
        <source>Saved here</source>
        <translation>Salvato qui</translation>
    </message>
</context>
<context>
    <name>fff::ui::InputRow</name>
    <message>
        <source>Delete removes a section; drag, or Alt with an arrow key, changes the order.</source>
        <translation>Canc toglie una sezione; trascinando, o con Alt e una freccia, cambi l’ordine.</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Togli</translation>
    </message>
    <message>
        <source>%1 (deleted)</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 (eliminata)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Scegli…</translation>
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
        <translation>Creata da un’operazione</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>Creata da</translation>
    </message>
    <message>
        <source>Image of</source>
        <translation>Immagine di</translation>
    </message>
    <message>
        <source>Leave this one out</source>
        <translation>Ometti questa</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Stacca</translation>
    </message>
    <message>
        <source>Turn this one into a drawn section; its operation still makes the others</source>
        <translation>Trasforma questa in una sezione disegnata; la sua operazione crea ancora le altre</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Fatta da</translation>
    </message>
    <message>
        <source>Changes to one of them apply to all</source>
        <translation>Ciò che cambi in una vale per tutte</translation>
    </message>
    <message>
        <source>Redraw it; everything made from it follows</source>
        <translation>Ridisegnala; tutto ciò che ne deriva la segue</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointPage</name>
    <message>
        <source>Joint</source>
        <translation>Incastro</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Fessure</translation>
    </message>
    <message>
        <source>Restore automatic settings</source>
        <translation>Ripristina le impostazioni automatiche</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Sezioni</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Opens</source>
        <translation>Si apre</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>Inverti le fessure</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fessura</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angolo</translation>
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
        <translation>Punto d’incontro</translation>
    </message>
    <message>
        <source>tab, %1 wide</source>
        <translation>linguetta, larga %1</translation>
    </message>
    <message>
        <source>closed, %1 long, %2 wide</source>
        <translation>chiusa, lunga %1, larga %2</translation>
    </message>
    <message>
        <source>%1 deep, %2 wide</source>
        <translation>profonda %1, larga %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuna</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 and %2 overlap.</source>
        <translation>%1 e %2 si sovrappongono.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>Accorcia %1</translation>
    </message>
    <message>
        <source>Meeting point %1</source>
        <translation>Punto d’incontro %1</translation>
    </message>
    <message>
        <source>The slit of %1 takes this share of the depth, that of %2 the rest</source>
        <translation>La fessura di %1 prende questa parte della profondità, quella di %2 il resto</translation>
    </message>
    <message>
        <source>Set by hand; automatic is 50&#x202f;%. %1</source>
        <translation>Impostato a mano; in automatico 50&#x202f;%. %1</translation>
    </message>
    <message>
        <source>Sections: %1 and %2</source>
        <translation>Sezioni: %1 e %2</translation>
    </message>
    <message>
        <source>Set by hand; the automatic setting can be restored</source>
        <translation>Impostato a mano; si può ripristinare l’impostazione automatica</translation>
    </message>
    <message>
        <source>%1 opens</source>
        <translation>%1 si apre</translation>
    </message>
    <message>
        <source>The side that the slit of %1 opens to; that of %2 opens to the other</source>
        <translation>Il lato verso cui si apre la fessura di %1; quella di %2 si apre dall’altro</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>In %1</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points again</source>
        <translation>Lascia di nuovo scegliere al programma tipo, direzione e punti d’incontro</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>In questo incastro nulla è impostato a mano</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointRows</name>
    <message>
        <source>Select the joint with %1</source>
        <translation>Seleziona l’incastro con %1</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Ancora nessuno</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointWords</name>
    <message>
        <source>cross lap</source>
        <translation>a croce</translation>
    </message>
    <message>
        <source>extended cross lap</source>
        <translation>a croce prolungato</translation>
    </message>
    <message>
        <source>mortise</source>
        <translation>mortasa</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>linguette</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>nessun incastro</translation>
    </message>
    <message>
        <source>Cross lap</source>
        <translation>A croce</translation>
    </message>
    <message>
        <source>Extended cross lap</source>
        <translation>A croce prolungato</translation>
    </message>
    <message>
        <source>Mortise</source>
        <translation>Mortasa</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Linguette</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuno</translation>
    </message>
    <message>
        <source>The clearance of their stock leaves a slit no width</source>
        <translation>Il gioco del materiale non lascia larghezza a una fessura</translation>
    </message>
    <message>
        <source>Slits cannot open to the outside: a hole is in the way</source>
        <translation>Le fessure non possono aprirsi verso l’esterno: c’è di mezzo un foro</translation>
    </message>
    <message>
        <source>In one place they could only slide one way, in another only the other</source>
        <translation>In un punto potrebbero scorrere solo in un verso, in un altro solo nell’altro</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin</source>
        <translation>Nulla le terrebbe: ci sono fori dove inizierebbero le fessure</translation>
    </message>
    <message>
        <source>One section reaches beyond the other, whichever way they slide</source>
        <translation>Una sezione oltrepassa l’altra, comunque scorrano</translation>
    </message>
    <message>
        <source>Neither section reaches beyond the other</source>
        <translation>Nessuna delle due sezioni oltrepassa l’altra</translation>
    </message>
    <message>
        <source>They meet in more than one place</source>
        <translation>Si incontrano in più di un punto</translation>
    </message>
    <message>
        <source>Neither section fits through a closed slit in the other</source>
        <translation>Nessuna delle due sezioni passa per una fessura chiusa nell’altra</translation>
    </message>
    <message>
        <source>One section only ends on the other</source>
        <translation>Una sezione termina soltanto sull’altra</translation>
    </message>
    <message>
        <source>Neither section ends on the other&apos;s face</source>
        <translation>Nessuna delle due sezioni termina sulla faccia dell’altra</translation>
    </message>
    <message>
        <source>There is no room for tabs and their slits</source>
        <translation>Non c’è spazio per le linguette e le loro fessure</translation>
    </message>
    <message>
        <source>They meet at less than 30°</source>
        <translation>Si incontrano a meno di 30°</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>A destra</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>A sinistra</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>In alto</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>In basso</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>In avanti</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeyRecorder</name>
    <message>
        <source>Press the keys</source>
        <translation>Premi i tasti</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeysList</name>
    <message>
        <source>Keys</source>
        <translation>Tasti</translation>
    </message>
    <message>
        <source>Save them as a page to print…</source>
        <translation>Salvali su una pagina da stampare…</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>Nella vista</translation>
    </message>
    <message>
        <source>Draw the first section</source>
        <translation>Disegnare la prima sezione</translation>
    </message>
    <message>
        <source>drag in the middle</source>
        <translation>trascinare al centro</translation>
    </message>
    <message>
        <source>Draw a section across another one</source>
        <translation>Disegnare una sezione di traverso a un’altra</translation>
    </message>
    <message>
        <source>drag out of it, go on</source>
        <translation>trascinare fuori, proseguire</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>Ruotare la vista</translation>
    </message>
    <message>
        <source>drag beside the model</source>
        <translation>trascinare accanto al modello</translation>
    </message>
    <message>
        <source>Come nearer</source>
        <translation>Avvicinarsi</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>rotella</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Spostare la vista</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>trascinare con il tasto centrale</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Selezionare</translation>
    </message>
    <message>
        <source>click</source>
        <translation>clic</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Selezionare un gruppo</translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation>Maiusc e trascinare</translation>
    </message>
    <message>
        <source>Do what can be done with it</source>
        <translation>Vedere che cosa si può farne</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>clic destro</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Aggiungere un punto</translation>
    </message>
    <message>
        <source>double click on the contour</source>
        <translation>doppio clic sul contorno</translation>
    </message>
    <message>
        <source>Draw without snapping</source>
        <translation>Disegnare senza aggancio</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>tenere Ctrl</translation>
    </message>
</context>
<context>
    <name>fff::ui::LayoutGroup</name>
    <message>
        <source>Layout</source>
        <translation>Disposizione</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margine</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Lastra</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>Parts in holes</source>
        <translation>Pezzi nei fori</translation>
    </message>
    <message>
        <source>Small parts may lie in the holes of large ones</source>
        <translation>I pezzi piccoli possono stare nei fori di quelli grandi</translation>
    </message>
</context>
<context>
    <name>fff::ui::LengthText</name>
    <message>
        <source>Millimetres</source>
        <translation>Millimetri</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimetri</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pollici</translation>
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
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Libreria</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>Aggiungi selezione</translation>
    </message>
    <message>
        <source>Put the selection into the library; without one, the whole model</source>
        <translation>Metti nella libreria la selezione; se non c’è, tutto il modello</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Cartella…</translation>
    </message>
    <message>
        <source>Choose the folder whose models are shown here</source>
        <translation>Scegli la cartella di cui mostrare qui i modelli</translation>
    </message>
    <message>
        <source>Parts that you keep appear here: select some sections, then click Add selection.</source>
        <translation>Qui compare ciò che conservi: seleziona delle sezioni, poi fai clic su Aggiungi selezione.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sezione</numerusform>
            <numerusform>%n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Library folder</source>
        <translation>Cartella della libreria</translation>
    </message>
    <message>
        <source>Nothing added: nothing is drawn yet.</source>
        <translation>Nulla di aggiunto: non è ancora disegnato nulla.</translation>
    </message>
    <message>
        <source>The library folder %1 cannot be created.</source>
        <translation>Impossibile creare la cartella della libreria %1.</translation>
    </message>
    <message>
        <source>%1 is in the library now.</source>
        <translation>%1 ora è nella libreria.</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 è nel cestino.</translation>
    </message>
    <message>
        <source>%1 could not be moved to the trash.</source>
        <translation>Impossibile spostare %1 nel cestino.</translation>
    </message>
    <message>
        <source>Add it to the model</source>
        <translation>Aggiungi al modello</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>Sposta nel cestino</translation>
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
        <translation>Spinta</translation>
    </message>
    <message>
        <source>Where it acts</source>
        <translation>Dove agisce</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Oggetto</translation>
    </message>
    <message>
        <source>Plain weight</source>
        <translation>Solo un peso</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Also in kg, oz or lb: 1.5 kg, 2 lb</source>
        <translation>Anche in kg, oz o lb: 1,5 kg, 2 lb</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Water in it</source>
        <translation>Acqua dentro</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Baricentro</translation>
    </message>
    <message>
        <source>Height above its place: the higher, the sooner the model tips over</source>
        <translation>Altezza sopra il suo punto: più è alta, prima il modello si ribalta</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Forza</translation>
    </message>
    <message>
        <source>10 N is about as much as 1 kg weighs</source>
        <translation>10 N è circa quanto pesa 1 kg</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Direzione X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Direzione Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Direzione Z</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Su</translation>
    </message>
    <message>
        <source>In the section&apos;s own plane, from its origin</source>
        <translation>Nel piano della sezione, dalla sua origine</translation>
    </message>
    <message>
        <source>Place X</source>
        <translation>Punto X</translation>
    </message>
    <message>
        <source>Place Y</source>
        <translation>Punto Y</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Distribuito</translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>In un punto</translation>
    </message>
    <message>
        <source>Over a patch</source>
        <translation>Su un’area</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>Lungo il bordo</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Appeso</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>On copies too</source>
        <translation>Anche sulle copie</translation>
    </message>
    <message>
        <source>Copies that operations make of its section carry one each</source>
        <translation>Ognuna delle copie che le operazioni fanno della sua sezione ne porta uno</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadTree</name>
    <message>
        <source>Weights and pushes</source>
        <translation>Pesi e spinte</translation>
    </message>
    <message>
        <source>F2 renames, Del removes.</source>
        <translation>F2 rinomina, Canc rimuove.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesi</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Spinte</translation>
    </message>
</context>
<context>
    <name>fff::ui::Loads</name>
    <message>
        <source>Push</source>
        <translation>Spinta</translation>
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
        <translation>Riferimento</translation>
    </message>
    <message>
        <source>Pulled in</source>
        <translation>Attratto</translation>
    </message>
    <message>
        <source>Bend the template into the plane of this section, so that the guides of others follow what was drawn</source>
        <translation>Piega il riferimento nel piano di questa sezione, così le guide delle altre seguono ciò che è stato disegnato</translation>
    </message>
    <message>
        <source>From within</source>
        <translation>Entro</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>Barra degli strumenti</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Ripeti</translation>
    </message>
    <message>
        <source>Repeat and blend sections</source>
        <translation>Ripeti sezioni e fanne transizioni</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation>Impossibile mostrare il modello: il driver grafico non offre OpenGL 3.3. Un driver più recente può aiutare.</translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation>Impossibile mostrare il modello su questo schermo.</translation>
    </message>
    <message>
        <source>Start a new model, continue one, or look at a sample.</source>
        <translation>Inizia un nuovo modello, continuane uno o guarda un esempio.</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>Recuperato: %n modello non salvato</numerusform>
            <numerusform>Recuperati: %n modelli non salvati</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Recuperato: %1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Scarta</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Mostra la cartella</translation>
    </message>
    <message>
        <source>This model is here to be adjusted. “Edit the design” brings all back.</source>
        <translation>Questo modello è qui per essere adattato. “Modifica il progetto” fa tornare tutto.</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <extracomment>in the search: %1 is a heading of the help</extracomment>
        <translation>Aiuto: %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MakingGroup</name>
    <message>
        <source>Suggest sections</source>
        <translation>Suggerisci sezioni</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Quante</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Suggerisci</translation>
    </message>
    <message>
        <source>Finds sections that show its form, hold each other and stand</source>
        <translation>Trova sezioni che ne mostrano la forma, si tengono a vicenda e stanno in piedi</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>Un’altra</translation>
    </message>
    <message>
        <source>A section that fits among those there</source>
        <translation>Una sezione che sta tra quelle presenti</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Altre</translation>
    </message>
    <message>
        <source>Other sections instead of the last</source>
        <translation>Altre sezioni al posto delle ultime</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Sfaccettature</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Facce</translation>
    </message>
    <message>
        <source>Make facets</source>
        <translation>Sfaccetta</translation>
    </message>
    <message>
        <source>Builds it of flat sheets with fingers along their edges. The mesh is simplified to so many faces first; those that lie flat together are one sheet.</source>
        <translation>Lo costruisce con lastre piane e denti lungo i bordi. La mesh viene prima semplificata a questo numero di facce; quelle su uno stesso piano diventano una sola lastra.</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Sviluppa</translation>
    </message>
    <message>
        <source>Lays it flat, to be cut of card in one piece or a few and folded along scored lines. Edges to join have the same number.</source>
        <translation>Lo stende in piano, da tagliare nel cartoncino in un pezzo solo o in pochi e piegare lungo linee cordonate. I bordi da unire hanno lo stesso numero.</translation>
    </message>
</context>
<context>
    <name>fff::ui::MarkGroup</name>
    <message>
        <source>Marks</source>
        <translation>Segni</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Testo</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Ruotato di</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>Segno %1</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>Inciso</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Cordonato</translation>
    </message>
    <message>
        <source>Delete this mark</source>
        <translation>Elimina questo segno</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>Altezza lettere</translation>
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
        <translation>Lettura di %1…</translation>
    </message>
    <message>
        <source>%1 is too large for a model, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 è troppo grande per un modello, quindi è diventato grande %2. La misura è in Riferimenti.</translation>
    </message>
    <message>
        <source>%1 does not say its unit, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 non conosce unità, quindi è diventato grande %2. La misura è in Riferimenti.</translation>
    </message>
    <message>
        <source>Meshes, pictures and drawings (%1)</source>
        <extracomment>%1 is a list of patterns such as *.stl</extracomment>
        <translation>Mesh, immagini e disegni (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Immagine incollata</translation>
    </message>
    <message>
        <source>Scale it like %1</source>
        <extracomment>a button; %1 is the name of a mesh</extracomment>
        <translation>Nella scala di %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Messaggio</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Dettagli</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Chiudi questo messaggio</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>E %n altro.</numerusform>
            <numerusform>E altri %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ModelPage</name>
    <message>
        <source>Model</source>
        <translation>Modello</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unità</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensioni</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>ancora nulla</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>New sections</source>
        <translation>Nuove sezioni</translation>
    </message>
    <message>
        <source>Stock of the sections that are drawn next</source>
        <translation>Materiale delle prossime sezioni che disegni</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Modifica il materiale</translation>
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
        <translation>Mostra dove il modello si flette o si stacca, più di quanto sia vero. Nulla viene cambiato.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Riproduci</translation>
    </message>
    <message>
        <source>Motion is reduced: use the slider</source>
        <translation>Il movimento è ridotto: usa il cursore</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>It is not known how it moves.</source>
        <translation>Non si sa come si muove.</translation>
    </message>
    <message>
        <source>Turn on “Sections bend” to see how it bends.</source>
        <translation>Attiva “Sezioni flessibili” per vedere come si flette.</translation>
    </message>
    <message>
        <source>Shown as it begins to come apart.</source>
        <translation>Mostrato mentre comincia a separarsi.</translation>
    </message>
    <message>
        <source>Bends %1, shown %2 times as far.</source>
        <extracomment>%1 is a length, %2 a number of times</extracomment>
        <translation>Si flette di %1, mostrato %2 volte tanto.</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <translation>Si flette di %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::NamedNumberGroup</name>
    <message>
        <source>Named values</source>
        <translation>Valori con nome</translation>
    </message>
    <message>
        <source>A name is a word of letters and digits, other than “t” and the units.</source>
        <translation>Un nome è una parola di lettere e cifre, diversa da “t” e dalle unità.</translation>
    </message>
    <message>
        <source>Delete this value</source>
        <translation>Elimina questo valore</translation>
    </message>
</context>
<context>
    <name>fff::ui::Naming</name>
    <message>
        <source>Section %1</source>
        <extracomment>the name of a section that nobody has named; %1 is its number</extracomment>
        <translation>Sezione %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::NumberEdit</name>
    <message>
        <source>mixed</source>
        <translation>vari</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <extracomment>%1 is the smallest value, with its unit</extracomment>
        <translation>Almeno %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <extracomment>%1 is the largest value, with its unit</extracomment>
        <translation>Al massimo %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::OffcutRows</name>
    <message>
        <source>Offcut</source>
        <translation>Ritaglio</translation>
    </message>
    <message>
        <source>A sheet of another size, which is used up before whole ones</source>
        <translation>Una lastra di altra misura, usata prima di quelle intere</translation>
    </message>
    <message>
        <source>From a drawing…</source>
        <translation>Da un disegno…</translation>
    </message>
    <message>
        <source>What is left of a sheet, as the largest outline of an SVG file in true size, with its holes</source>
        <translation>Ciò che resta di una lastra, come la sagoma più grande di un file SVG in grandezza reale, con i suoi fori</translation>
    </message>
    <message>
        <source>Width of the offcut</source>
        <translation>Larghezza del ritaglio</translation>
    </message>
    <message>
        <source>Height of the offcut</source>
        <translation>Altezza del ritaglio</translation>
    </message>
    <message>
        <source>How many of this offcut</source>
        <translation>Quanti di questo ritaglio</translation>
    </message>
    <message>
        <source>Take this offcut away</source>
        <translation>Togli questo ritaglio</translation>
    </message>
    <message>
        <source>%1, from a drawing</source>
        <extracomment>%1 is the size of the box of an offcut with an outline of its own</extracomment>
        <translation>%1, da un disegno</translation>
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
        <translation>Scegline un’altra</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Permettine di più</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Tieni così</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Scegli</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationPage</name>
    <message>
        <source>Exceptions</source>
        <translation>Eccezioni</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Converti</translation>
    </message>
    <message>
        <source>Turn what it makes into drawn sections; the operation itself is then gone</source>
        <translation>Trasforma in sezioni disegnate ciò che crea; l’operazione poi non c’è più</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Delete it and everything it makes</source>
        <translation>Elimina l’operazione e tutto ciò che crea</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Elementi</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Scegli</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>Permettine di più</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationTree</name>
    <message>
        <source>Operations, in order</source>
        <translation>Operazioni, in ordine</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows, Alt with an arrow key changes the order.</source>
        <translation>F2 rinomina, Spazio nasconde e mostra, Alt con una freccia cambia l’ordine.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>disattivata</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Nascosta: mostra</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Nascondi</translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation>Struttura</translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation>Filtra per nome o materiale</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Sezioni</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows.</source>
        <translation>F2 rinomina, Spazio nasconde e mostra.</translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation>Qui compaiono le sezioni man mano che le disegni.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Rinomina</translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1, in corso di disegno</translation>
    </message>
    <message>
        <source>Locked: unlock it</source>
        <translation>Bloccata: sblocca</translation>
    </message>
    <message>
        <source>Lock it</source>
        <translation>Blocca</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>Nascosta: mostra</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>Nascondi</translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation>Disegna qui una forma tenendo premuto il tasto sinistro.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a problem: its number in the list, and what it is: &quot;3 Sections overlap&quot;</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1, e %n altro qui</numerusform>
            <numerusform>%1, e altri %n qui</numerusform>
        </translation>
    </message>
    <message>
        <source>Working out the slits…</source>
        <translation>Calcolo delle fessure…</translation>
    </message>
    <message>
        <source>X %1   Y %2</source>
        <extracomment>place of a point: %1 and %2 are numbers, the second has a unit</extracomment>
        <translation>X %1   Y %2</translation>
    </message>
    <message>
        <source>%1 × %2 from the last point</source>
        <extracomment>how far it is to the side (%1) and up or down (%2, with a unit)</extracomment>
        <translation>%1 × %2 dall’ultimo punto</translation>
    </message>
    <message>
        <source>Mirrored across the slit</source>
        <translation>Specchiata rispetto alla fessura</translation>
    </message>
    <message>
        <source>Mirrored across the vertical</source>
        <translation>Specchiata rispetto alla verticale</translation>
    </message>
    <message>
        <source>Cut flat at the ground</source>
        <translation>Tagliata a filo del suolo</translation>
    </message>
    <message>
        <source>Ground %1 below this edge</source>
        <extracomment>%1 is a length</extracomment>
        <translation>Suolo %1 sotto questo bordo</translation>
    </message>
    <message>
        <source>Slit %1</source>
        <extracomment>%1 is its length, with a unit</extracomment>
        <translation>Fessura %1</translation>
    </message>
    <message>
        <source>Slit %1, %2</source>
        <extracomment>%1 is its length, with a unit; %2 says what it goes along: &quot;level&quot;</extracomment>
        <translation>Fessura %1, %2</translation>
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
        <translation>Come risulta dalle sezioni</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>Impostato a mano</translation>
    </message>
</context>
<context>
    <name>fff::ui::PartsTable</name>
    <message>
        <source>Parts list</source>
        <translation>Elenco pezzi</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensioni</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Area</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Numero</translation>
    </message>
</context>
<context>
    <name>fff::ui::PhysicsDock</name>
    <message>
        <source>Physics</source>
        <translation>Fisica</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Visualizzazione</translation>
    </message>
    <message>
        <source>Stress lines</source>
        <translation>Linee di tensione</translation>
    </message>
    <message>
        <source>Show from</source>
        <translation>Mostra da</translation>
    </message>
    <message>
        <source>Share of the sheet&apos;s strength; less is not shown</source>
        <translation>Parte della resistenza della lastra; sotto non viene mostrato nulla</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>elementi finiti</translation>
    </message>
    <message>
        <source>Sections bend</source>
        <translation>Sezioni flessibili</translation>
    </message>
    <message>
        <source>Where joints share a load, the stiffness of the sections decides how much each carries. Takes a while.</source>
        <translation>Dove più incastri si dividono un carico, è la rigidezza delle sezioni a decidere quanto ne porta ciascuno. Richiede un po’ di tempo.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ferma</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>Resistenza</translation>
    </message>
    <message>
        <source>Colours the selected section by the mass that each place of it can hold, besides what is on the model already. Takes a while.</source>
        <translation>Colora la sezione selezionata secondo la massa che ogni suo punto può reggere, oltre a ciò che è già sul modello. Richiede un po’ di tempo.</translation>
    </message>
    <message>
        <source>Weakest places</source>
        <translation>Punti più deboli</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Carichi</translation>
    </message>
    <message>
        <source>Put a weight on the model to see what it can hold.</source>
        <translation>Metti un peso sul modello per vedere quanto regge.</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>Peso proprio</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>Sul suolo</translation>
    </message>
    <message>
        <source>Add weight</source>
        <translation>Aggiungi peso</translation>
    </message>
    <message>
        <source>Add push</source>
        <translation>Aggiungi spinta</translation>
    </message>
    <message>
        <source>How strict</source>
        <translation>Severità</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Fattore di sicurezza</translation>
    </message>
    <message>
        <source>How many times its load the model must be able to carry to count as holding</source>
        <translation>Quante volte il suo carico deve poter portare il modello perché si possa dire che regge</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Fattore d’intaglio, max.</translation>
    </message>
    <message>
        <source>How far stress rises at inner corners follows from the length of the neck, up to this factor; slits with round ends need less</source>
        <translation>Quanto cresce la tensione negli angoli interni dipende dalla lunghezza della strozzatura, fino a questo fattore; con fessure dal fondo tondo ne serve meno</translation>
    </message>
    <message>
        <source>for months</source>
        <translation>per mesi</translation>
    </message>
    <message>
        <source>Loads stay</source>
        <translation>I carichi restano</translation>
    </message>
    <message>
        <source>A stock then holds less, as set for it: acrylic only a quarter</source>
        <translation>Allora un materiale regge meno, come impostato per esso: l’acrilico solo un quarto</translation>
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
        <translation>Rimuovi questa spinta</translation>
    </message>
    <message>
        <source>Remove this weight</source>
        <translation>Rimuovi questo peso</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>calcolo… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>calcolo…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>fermato</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>impossibile da calcolare</translation>
    </message>
    <message>
        <source>the selected section</source>
        <translation>la sezione selezionata</translation>
    </message>
    <message>
        <source>select a section</source>
        <translation>seleziona una sezione</translation>
    </message>
    <message>
        <source>Draw a section to see what it can hold.</source>
        <translation>Disegna una sezione per vedere quanto regge.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Non si è potuto calcolare se regge.</translation>
    </message>
    <message>
        <source>Older than the drawing, working…</source>
        <translation>Non aggiornato, calcolo…</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>Non sta in piedi; le tensioni non vengono mostrate.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Un incastro si sfila; le tensioni non vengono mostrate.</translation>
    </message>
    <message>
        <source>Strength unknown: a stock is not rated. Set its strength under Stocks.</source>
        <translation>Resistenza sconosciuta: un materiale non è valutato. Impostala in Materiali.</translation>
    </message>
    <message>
        <source>Up to date. Joints may share the load in many ways; the worst counts.</source>
        <translation>Aggiornato. Gli incastri possono dividersi il carico in molti modi; conta il peggiore.</translation>
    </message>
    <message>
        <source>Up to date. All forces balance.</source>
        <translation>Aggiornato. Tutte le forze sono in equilibrio.</translation>
    </message>
    <message>
        <source>%1 Bends %2.</source>
        <extracomment>the state of what is worked out, and a length</extracomment>
        <translation>%1 Si flette di %2.</translation>
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
        <translation>rispetto alla fessura</translation>
    </message>
    <message>
        <source>across the vertical</source>
        <translation>rispetto alla verticale</translation>
    </message>
    <message>
        <source>across the horizontal</source>
        <translation>rispetto all’orizzontale</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Collocazione</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Svincolata</translation>
    </message>
    <message>
        <source>It neither moves with the section that it is on, nor keeps its angle to it</source>
        <translation>Non si sposta con la sezione su cui sta e non mantiene l’angolo con essa</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloccata</translation>
    </message>
    <message>
        <source>It stays as it is, unless the section that it is on moves</source>
        <translation>Resta com’è, a meno che non si sposti la sezione su cui sta</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simmetrica</translation>
    </message>
    <message>
        <source>Changes to points of one half apply to the other</source>
        <translation>Ciò che cambi nei punti di una metà vale anche per l’altra</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Su</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nulla</translation>
    </message>
    <message>
        <source>Click another section to put it on</source>
        <translation>Fai clic su un’altra sezione su cui metterla</translation>
    </message>
    <message>
        <source>Not on another section</source>
        <translation>Non sta su un’altra sezione</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to it</source>
        <translation>Angolo d’incastro</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Segue</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>in proporzione</translation>
    </message>
    <message>
        <source>its left end</source>
        <translation>l’estremo sinistro</translation>
    </message>
    <message>
        <source>its right end</source>
        <translation>l’estremo destro</translation>
    </message>
    <message>
        <source>its lower end</source>
        <translation>l’estremo inferiore</translation>
    </message>
    <message>
        <source>its upper end</source>
        <translation>l’estremo superiore</translation>
    </message>
    <message>
        <source>How its place follows when a value stretches the section that it is on: as far as that is stretched there, or at its distance from an end</source>
        <translation>Come segue il suo posto quando un valore allunga la sezione su cui sta: di quanto quella si allunga lì, oppure alla sua distanza da un estremo</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X del suo centro</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y del suo centro</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z del suo centro</translation>
    </message>
    <message>
        <source>X of the direction it faces, of length 1</source>
        <translation>X della direzione in cui guarda, di lunghezza 1</translation>
    </message>
    <message>
        <source>Y of the direction it faces, of length 1</source>
        <translation>Y della direzione in cui guarda, di lunghezza 1</translation>
    </message>
    <message>
        <source>Z of the direction it faces, of length 1</source>
        <translation>Z della direzione in cui guarda, di lunghezza 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direzione</translation>
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
        <translation>Maniglia prima</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>Angolo prima</translation>
    </message>
    <message>
        <source>Handle out</source>
        <translation>Maniglia dopo</translation>
    </message>
    <message>
        <source>Angle out</source>
        <translation>Angolo dopo</translation>
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
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Liscio</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simmetrico</translation>
    </message>
</context>
<context>
    <name>fff::ui::PresetRow</name>
    <message>
        <source>Preset</source>
        <extracomment>a set of settings of a design&apos;s values that has a name, such as A5</extracomment>
        <translation>Preimpostazione</translation>
    </message>
    <message>
        <source>changed</source>
        <extracomment>in place of a preset&apos;s name: what is set is none of them</extracomment>
        <translation>modificata</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nome della preimpostazione</translation>
    </message>
    <message>
        <source>A5, four shelves …</source>
        <extracomment>names of presets as they could be</extracomment>
        <translation>A5, quattro ripiani…</translation>
    </message>
    <message>
        <source>Keep what is set now as a preset</source>
        <translation>Conserva come preimpostazione ciò che è impostato ora</translation>
    </message>
    <message>
        <source>Delete this preset</source>
        <translation>Elimina questa preimpostazione</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>Salva preimpostazione</translation>
    </message>
    <message>
        <source>Gives what is set now a name, such as A5, to come back to it</source>
        <translation>Dà un nome, per esempio A5, a ciò che è impostato ora, per tornarci</translation>
    </message>
</context>
<context>
    <name>fff::ui::ProblemMarks</name>
    <message>
        <source>%1 outside</source>
        <extracomment>%1 is a length: how far the centre of mass lies from the edge of the feet</extracomment>
        <translation>%1 fuori</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <extracomment>%1 is a length: how far it lies from their edge</extracomment>
        <translation>%1 dentro</translation>
    </message>
    <message>
        <source>%1 too high</source>
        <extracomment>%1 is a length: how far a foot ends above the ground</extracomment>
        <translation>%1 troppo in alto</translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>Proprietà</translation>
    </message>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>%n altro in Controlli.</numerusform>
            <numerusform>Altri %n in Controlli.</numerusform>
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
        <translation>Attiva</translation>
    </message>
    <message>
        <source>Switched off, it makes nothing but keeps its settings</source>
        <translation>Disattivata, non crea nulla ma conserva le sue impostazioni</translation>
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
        <translation>%1 su %2</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modello</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Nulla è selezionato</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sezione</numerusform>
            <numerusform>%n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>Le modifiche valgono per tutte</translation>
    </message>
    <message>
        <source>They overlap</source>
        <translation>Si sovrappongono</translation>
    </message>
    <message>
        <source>%1 · automatic</source>
        <translation>%1 · automatico</translation>
    </message>
    <message>
        <source>%1 · set by hand</source>
        <translation>%1 · impostato a mano</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n incastro</numerusform>
            <numerusform>%n incastri</numerusform>
        </translation>
    </message>
    <message>
        <source>Made by %1 · %2</source>
        <extracomment>%1 is the name of an operation, %2 a number of joints</extracomment>
        <translation>Creata da %1 · %2</translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation>Sezione · %1</translation>
    </message>
    <message>
        <source>Section · on %1 · %2</source>
        <translation>Sezione · su %1 · %2</translation>
    </message>
    <message>
        <source>%1 · switched off</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · disattivata</translation>
    </message>
    <message>
        <source>%1 · makes nothing</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · non crea nulla</translation>
    </message>
    <message>
        <source>%1 · %2 · up to date</source>
        <extracomment>%1 is the kind of an operation, %2 a number of sections</extracomment>
        <translation>%1 · %2 · aggiornata</translation>
    </message>
</context>
<context>
    <name>fff::ui::RecentMenu</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Apri recenti</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (manca)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Svuota questo elenco</translation>
    </message>
    <message>
        <source>Forget these names; the files stay</source>
        <translation>Dimentica questi nomi; i file restano</translation>
    </message>
</context>
<context>
    <name>fff::ui::RemarkRows</name>
    <message>
        <source>What to look out for</source>
        <translation>A che cosa badare</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Closes this and selects it in the model</source>
        <translation>Chiude questa finestra e lo seleziona nel modello</translation>
    </message>
</context>
<context>
    <name>fff::ui::ReplaceQuestion</name>
    <message>
        <source>Replace files</source>
        <translation>Sostituisci i file</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>Sostituire %n file esistente?</numerusform>
            <numerusform>Sostituire %n file esistenti?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sostituisci</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Replace this file?</source>
        <translation>Sostituire questo file?</translation>
    </message>
</context>
<context>
    <name>fff::ui::SampleTexts</name>
    <message>
        <source>along</source>
        <translation>orizzontale</translation>
    </message>
    <message>
        <source>Along a rib from ring to ring</source>
        <translation>Lungo una costola, da anello ad anello</translation>
    </message>
    <message>
        <source>Along a rib to the lower ring</source>
        <translation>Lungo una costola, fino all’anello inferiore</translation>
    </message>
    <message>
        <source>Arch</source>
        <translation>Arco</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>scarto</translation>
    </message>
    <message>
        <source>axis_x</source>
        <translation>asse_x</translation>
    </message>
    <message>
        <source>axis_y</source>
        <translation>asse_y</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Dorso</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>Trave</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Travi</translation>
    </message>
    <message>
        <source>Belly rib</source>
        <translation>Costola della pancia</translation>
    </message>
    <message>
        <source>between</source>
        <translation>tra</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Ripiano</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Ripiani</translation>
    </message>
    <message>
        <source>boards</source>
        <translation>ripiani</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corpo</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ramificazione</translation>
    </message>
    <message>
        <source>capital</source>
        <translation>maiuscola</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Celle</translation>
    </message>
    <message>
        <source>column</source>
        <translation>colonna</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonne</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>colonne</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Culla</translation>
    </message>
    <message>
        <source>cradle</source>
        <translation>culla</translation>
    </message>
    <message>
        <source>Crest</source>
        <translation>Cimasa</translation>
    </message>
    <message>
        <source>Cutlery</source>
        <translation>Posate</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>profondità</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>diametro</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>interasse</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>Divisorio</translation>
    </message>
    <message>
        <source>Dividers</source>
        <translation>Divisori</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>Orecchie</translation>
    </message>
    <message>
        <source>Far base</source>
        <translation>Base lontana</translation>
    </message>
    <message>
        <source>Far dancer</source>
        <translation>Ballerino lontano</translation>
    </message>
    <message>
        <source>Far dancer, leaning</source>
        <translation>Ballerino lontano, inclinato</translation>
    </message>
    <message>
        <source>Far dancers</source>
        <translation>Ballerini lontani</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>Abete</translation>
    </message>
    <message>
        <source>Fir across</source>
        <translation>Abete di traverso</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Piede</translation>
    </message>
    <message>
        <source>Fore legs</source>
        <translation>Zampe anteriori</translation>
    </message>
    <message>
        <source>Forks and teaspoons</source>
        <translation>Forchette e cucchiaini</translation>
    </message>
    <message>
        <source>Four shelves</source>
        <translation>Quattro ripiani</translation>
    </message>
    <message>
        <source>From axis to axis, level</source>
        <translation>Da asse ad asse, in orizzontale</translation>
    </message>
    <message>
        <source>From axis to axis, with some play</source>
        <translation>Da asse ad asse, con un po’ di gioco</translation>
    </message>
    <message>
        <source>From wall to wall</source>
        <translation>Da parete a parete</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Davanti</translation>
    </message>
    <message>
        <source>Front foot</source>
        <translation>Piede anteriore</translation>
    </message>
    <message>
        <source>Front legs</source>
        <translation>Zampe anteriori</translation>
    </message>
    <message>
        <source>Front rail</source>
        <translation>Traversa anteriore</translation>
    </message>
    <message>
        <source>Front wave</source>
        <translation>Onda anteriore</translation>
    </message>
    <message>
        <source>Glass of water</source>
        <translation>Bicchiere d’acqua</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Maniglia</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Testa</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altezza</translation>
    </message>
    <message>
        <source>Height of the capitals; a long name has to be smaller</source>
        <translation>Altezza delle maiuscole; un nome lungo va scritto più piccolo</translation>
    </message>
    <message>
        <source>Height of the cradles</source>
        <translation>Altezza delle culle</translation>
    </message>
    <message>
        <source>Height of the pinion&apos;s axis</source>
        <translation>Altezza dell’asse del pignone</translation>
    </message>
    <message>
        <source>Height of the wheel&apos;s axis</source>
        <translation>Altezza dell’asse della ruota</translation>
    </message>
    <message>
        <source>Hind foot</source>
        <translation>Piede posteriore</translation>
    </message>
    <message>
        <source>Hind legs</source>
        <translation>Zampe posteriori</translation>
    </message>
    <message>
        <source>Hind wave</source>
        <translation>Onda posteriore</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>Anca</translation>
    </message>
    <message>
        <source>Horns</source>
        <translation>Corna</translation>
    </message>
    <message>
        <source>How far beside its place below a rib meets the upper ring</source>
        <translation>Di quanto una costola incontra l’anello superiore più di lato rispetto a sotto</translation>
    </message>
    <message>
        <source>How far each rib leans</source>
        <translation>Quanto si inclina ogni costola</translation>
    </message>
    <message>
        <source>How much lower the pinion is, seen from the wheel</source>
        <translation>Quanto sta più in basso il pignone, visto dalla ruota</translation>
    </message>
    <message>
        <source>How wide the plate is, in heights of a capital</source>
        <translation>Quanto è larga la targhetta, in altezze di una maiuscola</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>La sua larghezza</translation>
    </message>
    <message>
        <source>Jars</source>
        <translation>Barattoli</translation>
    </message>
    <message>
        <source>Last rib</source>
        <translation>Ultima costola</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Zampa sinistra</translation>
    </message>
    <message>
        <source>Left leaf</source>
        <translation>Foglia sinistra</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Fianco sinistro</translation>
    </message>
    <message>
        <source>Left strip</source>
        <translation>Listello sinistro</translation>
    </message>
    <message>
        <source>Left wing</source>
        <translation>Ala sinistra</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Gamba</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Gambe</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>gambe</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>lettere</translation>
    </message>
    <message>
        <source>Long foot</source>
        <translation>Piede lungo</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>sotto</translation>
    </message>
    <message>
        <source>Lower ring</source>
        <translation>Anello inferiore</translation>
    </message>
    <message>
        <source>Lower slat</source>
        <translation>Stecca inferiore</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>Middle base</source>
        <translation>Base centrale</translation>
    </message>
    <message>
        <source>Middle dancer</source>
        <translation>Ballerino centrale</translation>
    </message>
    <message>
        <source>Middle dancer, leaning</source>
        <translation>Ballerino centrale, inclinato</translation>
    </message>
    <message>
        <source>Middle dancers</source>
        <translation>Ballerini centrali</translation>
    </message>
    <message>
        <source>Middle rib</source>
        <translation>Costola centrale</translation>
    </message>
    <message>
        <source>module</source>
        <translation>modulo</translation>
    </message>
    <message>
        <source>Mug</source>
        <translation>Tazza</translation>
    </message>
    <message>
        <source>Muzzle</source>
        <translation>Muso</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nome</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Targhetta</translation>
    </message>
    <message>
        <source>Near base</source>
        <translation>Base vicina</translation>
    </message>
    <message>
        <source>Near dancer</source>
        <translation>Ballerino vicino</translation>
    </message>
    <message>
        <source>Near dancer, leaning</source>
        <translation>Ballerino vicino, inclinato</translation>
    </message>
    <message>
        <source>Near dancers</source>
        <translation>Ballerini vicini</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>Collo</translation>
    </message>
    <message>
        <source>Of a rib, along it</source>
        <translation>Di una costola, nel senso della lunghezza</translation>
    </message>
    <message>
        <source>Of the boards, from end to end</source>
        <translation>Dei ripiani, da un’estremità all’altra</translation>
    </message>
    <message>
        <source>Of the drawer, inside</source>
        <translation>Del cassetto, all’interno</translation>
    </message>
    <message>
        <source>Of the glass</source>
        <translation>Del bicchiere</translation>
    </message>
    <message>
        <source>Of the highest wall</source>
        <translation>Della parete più alta</translation>
    </message>
    <message>
        <source>Of the pinion, from a gap to the wheel</source>
        <translation>Del pignone, a partire da un vano rivolto verso la ruota</translation>
    </message>
    <message>
        <source>Of the pinion, likewise</source>
        <translation>Del pignone, allo stesso modo</translation>
    </message>
    <message>
        <source>Of the sides</source>
        <translation>Dei fianchi</translation>
    </message>
    <message>
        <source>Of the sides; the crest stands higher</source>
        <translation>Dei fianchi; la cimasa arriva più in alto</translation>
    </message>
    <message>
        <source>Of the wheel</source>
        <translation>Della ruota</translation>
    </message>
    <message>
        <source>Of the wheel, to the ground of its gaps</source>
        <translation>Della ruota, fino al fondo dei vani</translation>
    </message>
    <message>
        <source>Of the wheel, to the tips of its teeth</source>
        <translation>Della ruota, fino alla punta dei denti</translation>
    </message>
    <message>
        <source>Other foot</source>
        <translation>Altro piede</translation>
    </message>
    <message>
        <source>Other pier</source>
        <translation>Altro pilone</translation>
    </message>
    <message>
        <source>Other rail</source>
        <translation>Altro corrimano</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Altro fianco</translation>
    </message>
    <message>
        <source>Other sill</source>
        <translation>Altra traversa</translation>
    </message>
    <message>
        <source>Other toe</source>
        <translation>Altro appoggio</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>Penne</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>fase</translation>
    </message>
    <message>
        <source>Pier</source>
        <translation>Pilone</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>Pignone</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>pignone</translation>
    </message>
    <message>
        <source>Pinion teeth</source>
        <translation>Denti del pignone</translation>
    </message>
    <message>
        <source>pinion_radius</source>
        <translation>raggio_pignone</translation>
    </message>
    <message>
        <source>pinion_root</source>
        <translation>fondo_pignone</translation>
    </message>
    <message>
        <source>pinion_y</source>
        <translation>pignone_y</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Placca</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>targhetta</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Placche</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>raggio</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>Corrimano</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Raggio</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Raggi</translation>
    </message>
    <message>
        <source>Rear rib</source>
        <translation>Costola posteriore</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>resto</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>Costola</translation>
    </message>
    <message>
        <source>Ribs</source>
        <translation>Costole</translation>
    </message>
    <message>
        <source>ribs</source>
        <translation>costole</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Zampa destra</translation>
    </message>
    <message>
        <source>Right leaf</source>
        <translation>Foglia destra</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>Fianco destro</translation>
    </message>
    <message>
        <source>Right strip</source>
        <translation>Listello destro</translation>
    </message>
    <message>
        <source>Right wing</source>
        <translation>Ala destra</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Anello</translation>
    </message>
    <message>
        <source>Ring of holes</source>
        <translation>Corona di fori</translation>
    </message>
    <message>
        <source>root</source>
        <translation>fondo</translation>
    </message>
    <message>
        <source>row</source>
        <translation>fila</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>File</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>file</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>Viti</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Seduta</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Ripiano</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Spalla</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Fianco</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Fianchi</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>Traversa</translation>
    </message>
    <message>
        <source>Size of the teeth: the diameter over their number</source>
        <translation>Misura dei denti: il diametro diviso per il loro numero</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Fette</translation>
    </message>
    <message>
        <source>Small glass</source>
        <translation>Bicchiere piccolo</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>Spina dorsale</translation>
    </message>
    <message>
        <source>Spoons and knives</source>
        <translation>Cucchiai e coltelli</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stella</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sole</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>Coda</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Denti</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>denti</translation>
    </message>
    <message>
        <source>Teeth of the pinion</source>
        <translation>Denti del pignone</translation>
    </message>
    <message>
        <source>The same without whole teeth</source>
        <translation>Lo stesso, senza i denti interi</translation>
    </message>
    <message>
        <source>Three shelves</source>
        <translation>Tre ripiani</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>inclinazione</translation>
    </message>
    <message>
        <source>Timber</source>
        <translation>Centina</translation>
    </message>
    <message>
        <source>Timbers</source>
        <translation>Centine</translation>
    </message>
    <message>
        <source>Toe</source>
        <translation>Appoggio</translation>
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
        <translation>Bicchiere da acqua</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>rotazione</translation>
    </message>
    <message>
        <source>Twig</source>
        <translation>Rametto</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>torsione</translation>
    </message>
    <message>
        <source>Upper ring</source>
        <translation>Anello superiore</translation>
    </message>
    <message>
        <source>Upper slat</source>
        <translation>Stecca superiore</translation>
    </message>
    <message>
        <source>Vertebrae of the neck</source>
        <translation>Vertebre del collo</translation>
    </message>
    <message>
        <source>Vertebrae of the tail</source>
        <translation>Vertebre della coda</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Parete</translation>
    </message>
    <message>
        <source>Whale</source>
        <translation>Balena</translation>
    </message>
    <message>
        <source>What the sheet has room for</source>
        <translation>Quanto ci sta sulla lastra</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Ruota</translation>
    </message>
    <message>
        <source>Where a tooth of the wheel is</source>
        <translation>Dove si trova un dente della ruota</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>Largo</translation>
    </message>
    <message>
        <source>width</source>
        <translation>larghezza</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>larghezze</translation>
    </message>
</context>
<context>
    <name>fff::ui::Samples</name>
    <message>
        <source>Fish</source>
        <translation>Pesce</translation>
    </message>
    <message>
        <source>Dachshund</source>
        <translation>Bassotto</translation>
    </message>
    <message>
        <source>Fir tree</source>
        <translation>Abete</translation>
    </message>
    <message>
        <source>Lamp shade</source>
        <translation>Paralume</translation>
    </message>
    <message>
        <source>Doll’s chair</source>
        <translation>Sedia per bambole</translation>
    </message>
    <message>
        <source>Glass holder</source>
        <translation>Portabicchieri</translation>
    </message>
    <message>
        <source>Desk organiser</source>
        <translation>Portaoggetti da scrivania</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>Scaffale</translation>
    </message>
    <message>
        <source>Drawer organiser</source>
        <translation>Divisorio per cassetto</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>Targhetta</translation>
    </message>
    <message>
        <source>Glass stand</source>
        <translation>Sostegno per bicchiere</translation>
    </message>
    <message>
        <source>Bear over a mesh</source>
        <translation>Orso su una mesh</translation>
    </message>
    <message>
        <source>Owl from pictures</source>
        <translation>Gufo da immagini</translation>
    </message>
    <message>
        <source>Hedgehog in slices</source>
        <translation>Riccio a fette</translation>
    </message>
    <message>
        <source>Fish bones</source>
        <translation>Lisca di pesce</translation>
    </message>
    <message>
        <source>Dinosaur</source>
        <translation>Dinosauro</translation>
    </message>
    <message>
        <source>Stag beetle</source>
        <translation>Cervo volante</translation>
    </message>
    <message>
        <source>Growing tree</source>
        <translation>Albero che cresce</translation>
    </message>
    <message>
        <source>Dancers in two poses</source>
        <translation>Ballerini in due pose</translation>
    </message>
    <message>
        <source>Footbridge</source>
        <translation>Passerella</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Ingranaggi</translation>
    </message>
    <message>
        <source>Whale in cells</source>
        <translation>Balena a celle</translation>
    </message>
    <message>
        <source>Cutlery man</source>
        <translation>Omino di posate</translation>
    </message>
    <message>
        <source>Glass on three legs</source>
        <translation>Bicchiere su tre gambe</translation>
    </message>
    <message>
        <source>Three thin legs: too weak</source>
        <translation>Tre gambe sottili: troppo deboli</translation>
    </message>
    <message>
        <source>Four thin legs: too weak</source>
        <translation>Quattro gambe sottili: troppo deboli</translation>
    </message>
    <message>
        <source>Three thick legs: barely</source>
        <translation>Tre gambe grosse: al limite</translation>
    </message>
    <message>
        <source>Four thick legs: safe</source>
        <translation>Quattro gambe grosse: sicure</translation>
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
        <translation>inizia comincia crea vuoto</translation>
    </message>
    <message>
        <source>load import flatfab txt</source>
        <translation>carica importa flatfab txt</translation>
    </message>
    <message>
        <source>add merge append combine</source>
        <translation>aggiungi unisci accoda combina</translation>
    </message>
    <message>
        <source>store write</source>
        <translation>memorizza registra scrivi</translation>
    </message>
    <message>
        <source>copy rename</source>
        <translation>copia rinomina</translation>
    </message>
    <message>
        <source>reload discard</source>
        <translation>ricarica scarta ripristina</translation>
    </message>
    <message>
        <source>print laser cutter cnc plotter svg dxf pdf gcode lightburn make fabricate</source>
        <translation>stampa laser taglio taglierina cnc fresa plotter svg dxf pdf gcode lightburn fabbrica produci</translation>
    </message>
    <message>
        <source>preferences options configure dark light theme language units inches mouse navigation autosave animation</source>
        <translation>preferenze opzioni configura scuro chiaro tema lingua unità pollici mouse navigazione salvataggio automatico animazione</translation>
    </message>
    <message>
        <source>keys hotkeys bindings</source>
        <translation>tasti tastiera hotkey scorciatoie</translation>
    </message>
    <message>
        <source>exit leave</source>
        <translation>esci abbandona chiudi</translation>
    </message>
    <message>
        <source>svg dxf import</source>
        <translation>svg dxf importa</translation>
    </message>
    <message>
        <source>svg dxf import engrave</source>
        <translation>svg dxf importa incidi</translation>
    </message>
    <message>
        <source>stl obj picture image photo trace reference background</source>
        <translation>stl obj immagine foto ricalca traccia riferimento sfondo</translation>
    </message>
    <message>
        <source>back oops</source>
        <translation>indietro torna</translation>
    </message>
    <message>
        <source>again forward</source>
        <translation>ripeti avanti di nuovo</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>appunti</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>copia clona</translation>
    </message>
    <message>
        <source>flip reflect symmetric</source>
        <translation>ribalta rifletti simmetrico</translation>
    </message>
    <message>
        <source>remove erase trash</source>
        <translation>rimuovi cancella cestino</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>tutto</translation>
    </message>
    <message>
        <source>search palette</source>
        <translation>cerca ricerca palette</translation>
    </message>
    <message>
        <source>zoom centre center home</source>
        <translation>zoom centra centro</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>zoom centra</translation>
    </message>
    <message>
        <source>look straight</source>
        <translation>guarda dritto perpendicolare</translation>
    </message>
    <message>
        <source>orthographic isometric parallel camera</source>
        <translation>ortografica isometrica parallela camera</translation>
    </message>
    <message>
        <source>transparent wireframe through</source>
        <translation>trasparente filo fil di ferro attraverso</translation>
    </message>
    <message>
        <source>slice inside half</source>
        <translation>taglio dentro metà</translation>
    </message>
    <message>
        <source>surface shell cover</source>
        <translation>superficie guscio rivestimento copertura</translation>
    </message>
    <message>
        <source>solo alone</source>
        <translation>solo sola isolata</translation>
    </message>
    <message>
        <source>unhide visible</source>
        <translation>rivela visibile</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>invisibile</translation>
    </message>
    <message>
        <source>grid floor</source>
        <translation>griglia pavimento terreno</translation>
    </message>
    <message>
        <source>share give customizer customise customize configure student class adjust sliders locked full window</source>
        <translation>condividi dai personalizza personalizzabile configura studente alunno classe regola cursori bloccato finestra intera</translation>
    </message>
    <message>
        <source>maximise maximize</source>
        <translation>massimizza ingrandisci</translation>
    </message>
    <message>
        <source>sidebars</source>
        <translation>barre laterali pannelli</translation>
    </message>
    <message>
        <source>layout default</source>
        <translation>disposizione predefinita</translation>
    </message>
    <message>
        <source>mirror half</source>
        <translation>specchio metà</translation>
    </message>
    <message>
        <source>floor feet base</source>
        <translation>pavimento terreno piedi base</translation>
    </message>
    <message>
        <source>magnet align guide</source>
        <translation>calamita magnete allinea guida snap</translation>
    </message>
    <message>
        <source>polygon line curve bezier path</source>
        <translation>poligono linea curva bezier tracciato</translation>
    </message>
    <message>
        <source>circle square rectangle polygon star</source>
        <translation>cerchio quadrato rettangolo poligono stella</translation>
    </message>
    <message>
        <source>engrave text letters etch label</source>
        <translation>incisione testo lettere scritta etichetta</translation>
    </message>
    <message>
        <source>move rotate turn scale resize</source>
        <translation>muovi ruota gira scala ridimensiona</translation>
    </message>
    <message>
        <source>opening window cutout</source>
        <translation>apertura finestra ritaglio buco</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>sostituisci</translation>
    </message>
    <message>
        <source>array pattern repeat row ribs</source>
        <translation>serie lineare motivo ripeti fila costole array</translation>
    </message>
    <message>
        <source>spin around</source>
        <translation>gira attorno rivoluzione</translation>
    </message>
    <message>
        <source>loft morph between</source>
        <translation>loft morph sfuma fra tra</translation>
    </message>
    <message>
        <source>tree fork</source>
        <translation>albero biforcazione</translation>
    </message>
    <message>
        <source>waffle crate lattice</source>
        <translation>waffle reticolo cassa traliccio</translation>
    </message>
    <message>
        <source>spokes wheel gear polar</source>
        <translation>raggi ruota ingranaggio polare</translation>
    </message>
    <message>
        <source>rotate polar pattern</source>
        <translation>ruota polare motivo</translation>
    </message>
    <message>
        <source>pattern repeat copies</source>
        <translation>motivo ripeti copie</translation>
    </message>
    <message>
        <source>waffle layers stl</source>
        <translation>waffle reticolo strati stl</translation>
    </message>
    <message>
        <source>convert explode apply</source>
        <translation>converti esplodi applica</translation>
    </message>
    <message>
        <source>error warning issue</source>
        <translation>errore avviso difetto</translation>
    </message>
    <message>
        <source>assembly instructions animation play manual</source>
        <translation>montaggio assemblaggio istruzioni animazione riproduci manuale</translation>
    </message>
    <message>
        <source>strength break simulation physics fem</source>
        <translation>resistenza rottura simulazione fisica fem</translation>
    </message>
    <message>
        <source>load mass force</source>
        <translation>carico massa forza</translation>
    </message>
    <message>
        <source>force load</source>
        <translation>forza carico</translation>
    </message>
    <message>
        <source>material thickness plywood acrylic kerf</source>
        <translation>spessore compensato acrilico plexiglass kerf solco</translation>
    </message>
    <message>
        <source>test piece kerf clearance slits comb</source>
        <translation>pezzo di prova kerf solco gioco fessure pettine tolleranza</translation>
    </message>
    <message>
        <source>nesting layout arrange</source>
        <translation>nesting impaginazione disponi</translation>
    </message>
    <message>
        <source>length distance size dimension</source>
        <translation>lunghezza distanza misura quota</translation>
    </message>
    <message>
        <source>scale size resize</source>
        <translation>scala misura ridimensiona</translation>
    </message>
    <message>
        <source>manual tutorial documentation guide</source>
        <translation>manuale guida tutorial documentazione</translation>
    </message>
    <message>
        <source>home welcome examples</source>
        <translation>home benvenuto esempi</translation>
    </message>
    <message>
        <source>version licence license</source>
        <translation>versione licenza</translation>
    </message>
</context>
<context>
    <name>fff::ui::SectionPage</name>
    <message>
        <source>Stock</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Incastri</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>Modifica il materiale</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Spessore</translation>
    </message>
    <message>
        <source>Thickness of the stock: all sections of this stock follow</source>
        <translation>Spessore del materiale: tutte le sezioni di questo materiale si adeguano</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>As all others</source>
        <translation>Come tutte le altre</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>How its parts may be turned on the sheet: one that keeps to the grain lies as it is drawn, or by half turns</source>
        <translation>Come si possono ruotare i suoi pezzi sulla lastra: chi segue la venatura sta come disegnato, o ruotato di mezzi giri</translation>
    </message>
    <message>
        <source>Another length stretches the contour about its slit, or its middle</source>
        <translation>Un’altra lunghezza allunga il contorno rispetto alla fessura o al centro</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Area</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Fori</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
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
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>Gruppi di impostazioni</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Generali</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Controlli</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Tastiera</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unità</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Millimetri (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Centimetri (cm)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Pollici (in)</translation>
    </message>
    <message>
        <source>What is shown and typed. Files always hold millimetres.</source>
        <translation>Ciò che viene mostrato e scritto. I file contengono sempre millimetri.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colori</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Come il sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Chiari</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Scuri</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contrasto elevato</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Lingua</translation>
    </message>
    <message>
        <source>Takes effect after a restart.</source>
        <translation>Ha effetto dopo un riavvio.</translation>
    </message>
    <message>
        <source>Show the start page at startup</source>
        <translation>Mostra la pagina iniziale all’avvio</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>Durata rotazione</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>How long the view takes, while you draw, to turn to the new plane. With 0 it jumps.</source>
        <translation>Quanto impiega la vista, mentre disegni, a ruotare verso il nuovo piano. Con 0 salta.</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>La vista ruota di</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane. With less, the section that you started on stays visible.</source>
        <translation>A 90° guardi dritto sul nuovo piano. Con meno resta visibile la sezione da cui hai iniziato.</translation>
    </message>
    <message>
        <source>Strokes follow a template within</source>
        <translation>I tratti seguono un riferimento entro</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mouse buttons like</source>
        <translation>Tasti del mouse come in</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom the view. Ctrl with the left button always turns it, Space with the left button moves it.</source>
        <translation>Quali tasti ruotano, spostano e ingrandiscono la vista. Ctrl con il tasto sinistro la ruota sempre, Spazio con il tasto sinistro la sposta.</translation>
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
        <translation>Il meno possibile</translation>
    </message>
    <message>
        <source>With as little as possible, the view jumps instead of turning.</source>
        <translation>Con il meno possibile, la vista salta invece di ruotare.</translation>
    </message>
    <message>
        <source>Stress colours for the colour-blind</source>
        <translation>Colori della tensione per daltonici</translation>
    </message>
    <message>
        <source>From light to dark instead of blue to red. Always so in high contrast.</source>
        <translation>Dal chiaro allo scuro invece che dal blu al rosso. Sempre così con contrasto elevato.</translation>
    </message>
    <message>
        <source>Warn about angles below</source>
        <translation>Avvisa per angoli sotto</translation>
    </message>
    <message>
        <source>The flatter two sections meet, the wider their slits have to be.</source>
        <translation>Più è piatto l’angolo tra due sezioni, più larghe devono essere le loro fessure.</translation>
    </message>
    <message>
        <source>Ignore overlaps below</source>
        <translation>Ignora sovrapposizioni sotto</translation>
    </message>
    <message>
        <source>An overlap of less than this is no problem.</source>
        <translation>Una sovrapposizione minore di questa non è un problema.</translation>
    </message>
    <message>
        <source>Look for an order of assembly for</source>
        <translation>Cerca un ordine di montaggio per</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>In the background, after each change. Allow more time if the checks find no order.</source>
        <translation>In sottofondo, dopo ogni modifica. Concedi più tempo se i controlli non trovano un ordine.</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>Fattore di sicurezza</translation>
    </message>
    <message>
        <source>How many times its load a model has to hold before it counts as strong enough.</source>
        <translation>Quante volte il suo carico deve reggere un modello per contare come abbastanza robusto.</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>Fattore d’intaglio, max.</translation>
    </message>
    <message>
        <source>How many times higher stress is taken to be at inner corners.</source>
        <translation>Quante volte più alta si considera la tensione negli angoli interni.</translation>
    </message>
    <message>
        <source>Loads stay on for months</source>
        <translation>I carichi restano per mesi</translation>
    </message>
    <message>
        <source>Back up unsaved work every</source>
        <translation>Copia di riserva del lavoro non salvato ogni</translation>
    </message>
    <message>
        <source>After a crash or a power cut you get it back, even if it was never saved. Your file is not touched.</source>
        <translation>Dopo un blocco del programma o un’interruzione di corrente lo ritrovi, anche se non era mai stato salvato. Il tuo file non viene toccato.</translation>
    </message>
    <message>
        <source>Keep the previous version when saving</source>
        <translation>Conserva la versione precedente quando salvi</translation>
    </message>
    <message>
        <source>Simple window</source>
        <translation>Finestra semplice</translation>
    </message>
    <message>
        <source>To draw, check and export; all else is out of the way.</source>
        <translation>Per disegnare, controllare ed esportare; tutto il resto non c’è.</translation>
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
        <translation>Pannello intero</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetGroup</name>
    <message>
        <source>On the sheet</source>
        <translation>Sulla lastra</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Lastra</translation>
    </message>
    <message>
        <source>Position X, Y</source>
        <translation>Posizione X, Y</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Ruotato di</translation>
    </message>
    <message>
        <source>keeps its place</source>
        <translation>mantiene il suo posto</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Fissato</translation>
    </message>
    <message>
        <source>P pins and unpins the selected part among the sheets</source>
        <translation>P fissa o libera il pezzo selezionato tra le lastre</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>too large for one</source>
        <translation>troppo grande per una</translation>
    </message>
    <message>
        <source>%1, its first part</source>
        <extracomment>%1 is &quot;1 of 2&quot;</extracomment>
        <translation>%1, il suo primo pezzo</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetView</name>
    <message>
        <source>%1 mm, to check the size</source>
        <translation>%1 mm, per verificare la scala</translation>
    </message>
    <message>
        <source>Sheet, as it will be cut</source>
        <translation>Lastra, come sarà tagliata</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move it, Home shows all of it.</source>
        <translation>Più e meno ingrandiscono e rimpiccioliscono, le frecce la spostano, Home la mostra tutta.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a part on a sheet: its number, and its section&apos;s name</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Offcut %1 stays whole</source>
        <extracomment>%1 is the size of what is left of a sheet</extracomment>
        <translation>Il ritaglio %1 resta intero</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message>
        <source>Sheets</source>
        <translation>Lastre</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Veloce</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Buona</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Ottima</translation>
    </message>
    <message>
        <source>How well parts are laid</source>
        <translation>Quanto bene vengono disposti i pezzi</translation>
    </message>
    <message>
        <source>Quick lays all parts again. Good takes about ten seconds. Best goes on until you stop it.</source>
        <translation>Veloce dispone di nuovo tutti i pezzi. Buona richiede circa dieci secondi. Ottima continua finché non la fermi.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ferma</translation>
    </message>
    <message>
        <source>Split by Grid</source>
        <translation>Dividi con Griglia</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Libera tutti</translation>
    </message>
    <message>
        <source>Draw a section and it will lie here, ready to cut.</source>
        <translation>Disegna una sezione e comparirà qui, pronta da tagliare.</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>Disposizione…</translation>
    </message>
    <message>
        <source>Nesting again…</source>
        <translation>Nuova disposizione…</translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>%n pezzo fissato non aveva spazio dov’era.</numerusform>
            <numerusform>%n pezzi fissati non avevano spazio dov’erano.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is too large for its sheet.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 è troppo grande per la sua lastra.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 e %n altra sono troppo grandi per le loro lastre.</numerusform>
            <numerusform>%1 e altre %n sono troppo grandi per le loro lastre.</numerusform>
        </translation>
    </message>
    <message>
        <source>Add an offcut</source>
        <translation>Aggiungi un ritaglio</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>%n lastra in più di quante ce ne sono</numerusform>
            <numerusform>%n lastre in più di quante ce ne sono</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 of cutting</source>
        <extracomment>%1 are the parts, %2 is how far the machine cuts</extracomment>
        <translation>%1 · %2 di taglio</translation>
    </message>
    <message>
        <source>keeps the best so far, %1 s</source>
        <extracomment>%1 are seconds</extracomment>
        <translation>tiene la migliore finora, %1 s</translation>
    </message>
    <message>
        <source>Nesting… %1 % used</source>
        <extracomment>%1 is how much of the sheets is filled</extracomment>
        <translation>Disposizione… %1 % utilizzato</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 % used · %4 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine cuts</extracomment>
        <translation>%1 su %2 · %3 % utilizzato · %4 di taglio</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message>
        <source>Sheets, as they will be cut</source>
        <translation>Lastre, come saranno tagliate</translation>
    </message>
    <message>
        <source>Page Up and Page Down go from part to part, the arrow keys move a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home shows all sheets.</source>
        <translation>Pag su e Pag giù vanno da pezzo a pezzo, le frecce spostano un pezzo di 1 mm, R lo ruota, P lo fissa. Più e meno ingrandiscono e rimpiccioliscono, Home mostra tutte le lastre.</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · turned %4°</source>
        <extracomment>a part on a sheet: its number, its section&apos;s name, its size, and by how much it is turned</extracomment>
        <translation>%1 %2 · %3 · ruotato di %4°</translation>
    </message>
    <message>
        <source>There is no room for it.</source>
        <translation>Non c’è spazio per questo pezzo.</translation>
    </message>
    <message>
        <source>It may not be turned by so little.</source>
        <translation>Non si può ruotare di così poco.</translation>
    </message>
    <message>
        <source>It lies as it is drawn.</source>
        <translation>Sta come è disegnato.</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>Lastra %1 di %2</translation>
    </message>
    <message>
        <source>Too large</source>
        <translation>Troppo grande</translation>
    </message>
    <message>
        <source>grain ↔</source>
        <translation>venatura ↔</translation>
    </message>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · %n pezzo · %1 % utilizzato</numerusform>
            <numerusform> · %n pezzi · %1 % utilizzato</numerusform>
        </translation>
    </message>
    <message>
        <source>Offcut, sheet %1 of %2</source>
        <translation>Ritaglio, lastra %1 di %2</translation>
    </message>
    <message>
        <source>Pinned: stays where it lies. Click to unpin it.</source>
        <translation>Fissato: resta dove sta. Fai clic per liberarlo.</translation>
    </message>
    <message>
        <source>Drag a part elsewhere, or click it to select it.</source>
        <translation>Trascina un pezzo altrove, o fai clic per selezionarlo.</translation>
    </message>
    <message>
        <source>Click to unpin &lt;b&gt;%1&lt;/b&gt;.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Fai clic per liberare &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is too large for its sheet. Click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; è troppo grande per la sua lastra. Fai clic per selezionarlo.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere, or click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Trascina &lt;b&gt;%1&lt;/b&gt; altrove, o fai clic per selezionarlo.</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere. &lt;kbd&gt;R&lt;/kbd&gt; turns it, &lt;kbd&gt;P&lt;/kbd&gt; pins it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>Trascina &lt;b&gt;%1&lt;/b&gt; altrove. &lt;kbd&gt;R&lt;/kbd&gt; lo ruota, &lt;kbd&gt;P&lt;/kbd&gt; lo fissa.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ShortcutEditor</name>
    <message>
        <source>Filter by name or keys</source>
        <translation>Filtra per nome o tasti</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>No keys for this command</source>
        <translation>Nessun tasto per questo comando</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>The original keys of this command</source>
        <translation>I tasti originali di questo comando</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Ripristina tutto</translation>
    </message>
    <message>
        <source>The original keys of all commands</source>
        <translation>I tasti originali di tutti i comandi</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>Usalo qui</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Comandi e scorciatoie</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Scorciatoia</translation>
    </message>
    <message>
        <source>Works</source>
        <translation>Funziona</translation>
    </message>
    <message>
        <source>in the view</source>
        <translation>nella vista</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>ovunque</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Scegli un comando</translation>
    </message>
    <message>
        <source>Keys for %1:</source>
        <translation>Tasti per %1:</translation>
    </message>
    <message>
        <source>Changed by you</source>
        <translation>Cambiati da te</translation>
    </message>
    <message>
        <source>%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are for commands that work in the view.</source>
        <translation>%1 da solo disturberebbe la scrittura. Tieni premuto anche Ctrl o Alt; i tasti singoli sono per i comandi che funzionano nella vista.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 appartiene a “%2”.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message>
        <source>Between %1 it would bulge far out: one more section across says how far.</source>
        <extracomment>%1 names the sections round a place</extracomment>
        <translation>Tra %1 si gonfierebbe molto verso l’esterno: un’altra sezione di traverso direbbe fin dove.</translation>
    </message>
    <message>
        <source>Between %1 it would fold over itself.</source>
        <translation>Tra %1 si ripiegherebbe su sé stessa.</translation>
    </message>
    <message>
        <source>What is between %1 cannot be told from their contours.</source>
        <translation>Dai contorni non si può dire che cosa c’è tra %1.</translation>
    </message>
    <message>
        <source>Skin: working… %1&#x202f;%</source>
        <translation>Pelle: calcolo… %1&#x202f;%</translation>
    </message>
    <message>
        <source>Skin: working…</source>
        <translation>Pelle: calcolo…</translation>
    </message>
    <message>
        <source>Skin: stopped</source>
        <translation>Pelle: fermata</translation>
    </message>
    <message>
        <source>Skin: could not be worked out</source>
        <translation>Pelle: impossibile da calcolare</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Pelle</translation>
    </message>
    <message>
        <source>Skin: nothing to cover</source>
        <translation>Pelle: nulla da coprire</translation>
    </message>
    <message>
        <source>Skin: no contours cross</source>
        <translation>Pelle: nessun contorno si incrocia</translation>
    </message>
    <message>
        <source>Click to stop.</source>
        <translation>Fai clic per fermare.</translation>
    </message>
    <message>
        <source>A skin needs sections that cross each other and end in the same place there.</source>
        <translation>Una pelle ha bisogno di sezioni che si incrociano e lì terminano nello stesso punto.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>%n superficie</numerusform>
            <numerusform>%n superfici</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1; %n zona resta aperta.</numerusform>
            <numerusform>%1; %n zone restano aperte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to see the sections alone again.</source>
        <translation>Fai clic per rivedere solo le sezioni.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SlitRows</name>
    <message>
        <source>Square</source>
        <translation>Quadrato</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Tondo</translation>
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
        <translation>Fondo fessura</translation>
    </message>
    <message>
        <source>The inner end of a slit. A laser cuts it square; a mill&apos;s round tool cannot reach its corners. Round: a round bottom beyond the square one. Dogbone: an arc through each corner. T-bone: an arc in each wall; the bottom stays flat.</source>
        <translation>L’estremità interna di una fessura. Un laser la taglia quadrata; l’utensile tondo di una fresatrice non arriva negli angoli. Tondo: un fondo tondo oltre quello quadrato. Dogbone: un arco attraverso ogni angolo. T-bone: un arco in ogni parete; il fondo resta piatto.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Utensile</translation>
    </message>
    <message>
        <source>Diameter of the mill&apos;s tool. The arcs are drawn a little larger, so that it goes round them.</source>
        <translation>Diametro dell’utensile della fresatrice. Gli archi vengono disegnati un po’ più grandi, così riesce a percorrerli.</translation>
    </message>
    <message>
        <source>A square end has no tool. Choose another slit end for a mill.</source>
        <translation>Un fondo quadrato non ha utensile. Per una fresatrice scegli un altro fondo.</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Invito</translation>
    </message>
    <message>
        <source>Chamfer of both walls at a slit&apos;s mouth, at 45°, so that sections slide in easily. Half to all of the thickness is usual; 0: none.</source>
        <translation>Smusso a 45° delle due pareti all’imbocco di una fessura, così le sezioni entrano facilmente. Di solito da metà a tutto lo spessore; 0: nessuno.</translation>
    </message>
    <message>
        <source>Friction bumps</source>
        <translation>Rilievi d’attrito</translation>
    </message>
    <message>
        <source>Height of a small bump on each wall of a slit, which presses on the section in it. It has to be more than half of the clearance; 0: none.</source>
        <translation>Altezza di un piccolo rilievo su ogni parete di una fessura, che preme sulla sezione al suo interno. Deve superare la metà del gioco; 0: nessuno.</translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message>
        <source>section</source>
        <translation>sezione</translation>
    </message>
    <message>
        <source>generated section</source>
        <translation>sezione generata</translation>
    </message>
    <message>
        <source>on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>su %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloccata</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>ha un problema</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>nessun problema</translation>
    </message>
    <message>
        <source>Joint of %1 and %2</source>
        <translation>Incastro di %1 e %2</translation>
    </message>
    <message>
        <source>%1, operation</source>
        <translation>%1, operazione</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is what a weight or a push is called, %2 the name of a section</extracomment>
        <translation>%1 su %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>%n sezione selezionata</numerusform>
            <numerusform>%n sezioni selezionate</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Pagina iniziale</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuovo</translation>
    </message>
    <message>
        <source>Draw a model of your own</source>
        <translation>Disegna un modello tuo</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>Apri un modello, anche di FlatFab</translation>
    </message>
    <message>
        <source>No account, nothing leaves this computer.</source>
        <translation>Nessun account, nulla lascia questo computer.</translation>
    </message>
    <message>
        <source>Show at startup</source>
        <translation>Mostra all’avvio</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recenti</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Esempi</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Scarta</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>Recuperato: %1</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Mostra la cartella</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manca</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Togli da questo elenco</translation>
    </message>
    <message>
        <source>Open a copy of it</source>
        <translation>Aprine una copia</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sezione</numerusform>
            <numerusform>%n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a number of sections, %2 when it was opened last</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Your first model in 3 minutes</source>
        <translation>Il tuo primo modello in 3 minuti</translation>
    </message>
    <message>
        <source>Draw, check and cut a model, one step at a time</source>
        <translation>Disegnare, controllare e tagliare un modello, un passo alla volta</translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation>Che cosa fa il prossimo gesto</translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation>Numero di sezioni</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>Dimensioni del modello</translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation>Massa del modello</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unità</translation>
    </message>
    <message>
        <source>Unit of all lengths</source>
        <translation>Unità di tutte le lunghezze</translation>
    </message>
    <message>
        <source>Undid “%1”.</source>
        <translation>Annullato “%1”.</translation>
    </message>
    <message>
        <source>Undid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; brings it back.</source>
        <translation>Annullato “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; lo rifà.</translation>
    </message>
    <message>
        <source>Redid “%1”.</source>
        <translation>Rifatto “%1”.</translation>
    </message>
    <message>
        <source>Redid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; takes it back.</source>
        <translation>Rifatto “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; lo annulla.</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sezione</numerusform>
            <numerusform>%n sezioni</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsBar</name>
    <message>
        <source>Steps of the assembly</source>
        <translation>Passi del montaggio</translation>
    </message>
    <message>
        <source>Export steps…</source>
        <translation>Esporta passi…</translation>
    </message>
    <message>
        <source>Close the steps (Esc)</source>
        <translation>Chiudi i passi (Esc)</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>Passo precedente (Sinistra)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Riproduci (Spazio)</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>Passo successivo (Destra)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Pull the parts apart</source>
        <translation>Allontana i pezzi tra loro</translation>
    </message>
    <message>
        <source>Exploded</source>
        <translation>Esploso</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pausa (Spazio)</translation>
    </message>
    <message>
        <source>Write all steps to a PDF to print, a web page for phones, or a picture of each</source>
        <translation>Scrivi tutti i passi in un PDF da stampare, in una pagina web per telefoni, o un’immagine di ognuno</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message>
        <source>All steps, to print (*.pdf)</source>
        <translation>Tutti i passi, da stampare (*.pdf)</translation>
    </message>
    <message>
        <source>Pictures, one for each step (*.png)</source>
        <translation>Immagini, una per ogni passo (*.png)</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>Esporta passi</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>Esportazione di %1…</translation>
    </message>
    <message>
        <source>Nothing was written: the export was cancelled.</source>
        <translation>Nulla è stato scritto: l’esportazione è stata annullata.</translation>
    </message>
    <message>
        <source>The steps could not be exported: no picture can be made on this display.</source>
        <translation>Impossibile esportare i passi: su questo schermo non si può creare nessuna immagine.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n passo</numerusform>
            <numerusform>%n passi</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>Esportato in %2: %1.</translation>
    </message>
    <message>
        <source>Exported %1 to %2 … %3.</source>
        <translation>Esportato in %2 … %3: %1.</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>Esporta altrove…</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Pagina web (*.html)</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPage</name>
    <message>
        <source>This browser does not show the model in 3D. Here is what to do, step by step.</source>
        <translation>Questo browser non mostra il modello in 3D. Ecco che cosa fare, passo dopo passo.</translation>
    </message>
    <message>
        <source>There are no pictures: none could be made on the display of the computer that wrote this page.</source>
        <translation>Mancano le immagini: sullo schermo del computer che ha scritto questa pagina non se ne è potuta creare nessuna.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numero</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Drag to turn the model, pinch or scroll to zoom, tap twice to see all of it.</source>
        <translation>Trascina per girare il modello, usa due dita o la rotella per ingrandirlo, tocca due volte per vederlo tutto.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Riproduci</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Finito</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Passo precedente</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Passo successivo</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pezzi</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message>
        <source>1 part</source>
        <translation>1 pezzo</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n pezzo</numerusform>
            <numerusform>%n pezzi</numerusform>
        </translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 lastra</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n lastra</numerusform>
            <numerusform>%n lastre</numerusform>
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
            <numerusform>%n passi</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Pagina %1 di %2</translation>
    </message>
    <message>
        <source>How it goes together</source>
        <translation>Come si monta</translation>
    </message>
    <message>
        <source>%1, from %2, in %3.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;2 sheets&quot;, %3 &quot;38 steps&quot;</extracomment>
        <translation>%1, da %2, in %3.</translation>
    </message>
    <message>
        <source>The numbers are those engraved on the parts. At every slit there is the number of its joint after a short bar, the same on both of its parts.</source>
        <translation>I numeri sono quelli incisi sui pezzi. A ogni fessura, dopo una breve lineetta, c’è il numero del suo incastro, lo stesso su entrambi i suoi pezzi.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>e %n altro</numerusform>
            <numerusform>e altri %n</numerusform>
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
        <translation>Il modello è cambiato, quindi i suoi passi non vengono mostrati.</translation>
    </message>
    <message>
        <source>The steps cannot be shown on this display.</source>
        <translation>Impossibile mostrare i passi su questo schermo.</translation>
    </message>
    <message>
        <source>The steps will not be shown.</source>
        <translation>I passi non verranno mostrati.</translation>
    </message>
    <message>
        <source>Working out the order of assembly; the steps are shown as soon as it is known.</source>
        <translation>Calcolo dell’ordine di montaggio; i passi compariranno appena si conosce.</translation>
    </message>
    <message>
        <source>The steps cannot be shown: %1.</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>Impossibile mostrare i passi: %1.</translation>
    </message>
    <message>
        <source>The order of assembly is known now; “Show the steps” shows it.</source>
        <translation>Ora l’ordine di montaggio è noto; “Mostra i passi” lo mostra.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing is there yet.&lt;/b&gt; Step 1: %1</source>
        <translation>&lt;b&gt;Non c’è ancora nulla.&lt;/b&gt; Passo 1: %1</translation>
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
        <translation>Compensato di betulla</translation>
    </message>
    <message>
        <source>Birch plywood 4 mm</source>
        <translation>Compensato di betulla 4 mm</translation>
    </message>
    <message>
        <source>Birch plywood 6.5 mm</source>
        <translation>Compensato di betulla 6,5 mm</translation>
    </message>
    <message>
        <source>Birch plywood 9 mm</source>
        <translation>Compensato di betulla 9 mm</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>MDF</translation>
    </message>
    <message>
        <source>Acrylic</source>
        <translation>Acrilico</translation>
    </message>
    <message>
        <source>Acrylic, clear</source>
        <translation>Acrilico trasparente</translation>
    </message>
    <message>
        <source>Acrylic, red</source>
        <translation>Acrilico rosso</translation>
    </message>
    <message>
        <source>Corrugated board B</source>
        <translation>Cartone ondulato B</translation>
    </message>
    <message>
        <source>Corrugated board C</source>
        <translation>Cartone ondulato C</translation>
    </message>
    <message>
        <source>Corrugated board E</source>
        <translation>Cartone ondulato E</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Cartoncino</translation>
    </message>
    <message>
        <source>Basswood</source>
        <translation>Tiglio</translation>
    </message>
    <message>
        <source>POM</source>
        <translation>POM</translation>
    </message>
    <message>
        <source>Aluminium 6061</source>
        <translation>Alluminio 6061</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Use %1 for new sections</source>
        <translation>Usa %1 per le nuove sezioni</translation>
    </message>
    <message>
        <source>%1: %2 → %3 thick</source>
        <extracomment>a step of the history; %1 is a stock, %2 and %3 are lengths</extracomment>
        <translation>%1: spessore %2 → %3</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockBox</name>
    <message>
        <source>Stock of the next section</source>
        <translation>Materiale della prossima sezione</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Spessore</translation>
    </message>
    <message>
        <source>Stock of the next section: %1</source>
        <translation>Materiale della prossima sezione: %1</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>Materiali…</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockEditor</name>
    <message>
        <source>Stocks</source>
        <translation>Materiali</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
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
        <translation>Lastra</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Spessore</translation>
    </message>
    <message>
        <source>Sheet W × H</source>
        <translation>Lastra L × A</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densità</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>non noto</translation>
    </message>
    <message>
        <source>0 means not known</source>
        <translation>0 significa non noto</translation>
    </message>
    <message>
        <source>Price of a sheet</source>
        <translation>Prezzo di una lastra</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>Larghezza della lastra</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>Altezza della lastra</translation>
    </message>
    <message>
        <source>Common sheets</source>
        <translation>Lastre comuni</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Resistenza</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>Resistenza a trazione</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Flexural strength</source>
        <translation>Resistenza a flessione</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidezza</translation>
    </message>
    <message>
        <source>GPa</source>
        <translation>GPa</translation>
    </message>
    <message>
        <source>before it breaks</source>
        <translation>prima di rompersi</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Si piega</translation>
    </message>
    <message>
        <source>Like metal: above these strengths it stays bent</source>
        <translation>Come il metallo: sopra queste resistenze resta piegato</translation>
    </message>
    <message>
        <source>Holds for months</source>
        <translation>Regge per mesi</translation>
    </message>
    <message>
        <source>Share of its strength under a load that stays: acrylic creeps and crazes</source>
        <translation>Parte della sua resistenza sotto un carico che resta: l’acrilico cede nel tempo e si screpola</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Taglio</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>Solco di taglio (intero)</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>Gioco fessure</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>Fessura disegnata</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>Fessure</translation>
    </message>
    <message>
        <source>not rated</source>
        <translation>non valutato</translation>
    </message>
    <message>
        <source>0 means not rated</source>
        <translation>0 significa non valutato</translation>
    </message>
    <message>
        <source>No sections are made of it</source>
        <translation>Nessuna sezione è fatta con questo</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sezione</numerusform>
            <numerusform>%n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>none: the kerf is wider than the slit</source>
        <translation>nessuna: il solco di taglio è più largo della fessura</translation>
    </message>
    <message>
        <source>Thickness, clearance and kerf of two sections of this stock that stand square on each other</source>
        <translation>Spessore, gioco e solco di taglio di due sezioni di questo materiale perpendicolari tra loro</translation>
    </message>
    <message>
        <source>Sold as</source>
        <translation>Venduto come</translation>
    </message>
    <message>
        <source>The thickness by which the sheet is bought; as a rule it is not quite that</source>
        <translation>Lo spessore con cui si compra la lastra; di solito non è proprio quello</translation>
    </message>
    <message>
        <source>with calipers, by me</source>
        <translation>con il calibro, da me</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Misurato</translation>
    </message>
    <message>
        <source>Export asks once how thick the sheets are that you will cut</source>
        <translation>L’esportazione chiede una volta quanto sono spesse le lastre che taglierete</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>quante ne servono</translation>
    </message>
    <message>
        <source>0 means as many as it takes</source>
        <translation>0 significa quante ne servono</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>Quante ce ne sono</translation>
    </message>
    <message>
        <source>Used up first</source>
        <translation>Usati prima</translation>
    </message>
    <message>
        <source>An offcut from a drawing</source>
        <translation>Un ritaglio da un disegno</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>Disegni (%1)</translation>
    </message>
    <message>
        <source>By machine</source>
        <translation>Per macchina</translation>
    </message>
    <message>
        <source>Kept where a kerf was typed while that machine was chosen in Export</source>
        <translation>Conservato dove un solco di taglio è stato scritto mentre quella macchina era scelta nell’esportazione</translation>
    </message>
    <message>
        <source>Size and number</source>
        <translation>Dimensioni e numero</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message>
        <source>Stocks of this model</source>
        <translation>Materiali di questo modello</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
    </message>
    <message>
        <source>Add a stock from the presets</source>
        <translation>Aggiungi un materiale tra quelli predefiniti</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplica</translation>
    </message>
    <message>
        <source>Add a stock with the same numbers</source>
        <translation>Aggiungi un materiale con gli stessi numeri</translation>
    </message>
    <message>
        <source>Save this stock in a file, for other models and other people</source>
        <translation>Salva questo materiale in un file, per altri modelli e altre persone</translation>
    </message>
    <message>
        <source>Save the stock in a file</source>
        <translation>Salva il materiale in un file</translation>
    </message>
    <message>
        <source>Remove the stock</source>
        <translation>Rimuovi il materiale</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n sezione</numerusform>
            <numerusform>%n sezioni</numerusform>
        </translation>
    </message>
    <message>
        <source>A model needs a stock; add another one first</source>
        <translation>Un modello ha bisogno di un materiale; aggiungine prima un altro</translation>
    </message>
    <message>
        <source>Remove this stock</source>
        <translation>Rimuovi questo materiale</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Da un file…</translation>
    </message>
    <message>
        <source>Add a stock from a file</source>
        <translation>Aggiungi un materiale da un file</translation>
    </message>
    <message>
        <source>FlatFitFab models (%1)</source>
        <translation>Modelli FlatFitFab (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>Fai la sua %n sezione con</numerusform>
            <numerusform>Fai le sue %n sezioni con</numerusform>
        </translation>
    </message>
    <message>
        <source>Add stock %1</source>
        <translation>Aggiungi materiale %1</translation>
    </message>
    <message>
        <source>Remove stock %1</source>
        <translation>Rimuovi materiale %1</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
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
        <translation>Nella strozzatura</translation>
    </message>
    <message>
        <source>At its corner</source>
        <translation>Nel suo angolo</translation>
    </message>
    <message>
        <source>Bent in its plane</source>
        <translation>Flessione nel piano</translation>
    </message>
    <message>
        <source>Bent across the sheet</source>
        <translation>Flessione fuori dal piano</translation>
    </message>
    <message>
        <source>Pressed along</source>
        <translation>Compressione</translation>
    </message>
    <message>
        <source>Pulled along</source>
        <translation>Trazione</translation>
    </message>
    <message>
        <source>Sheared</source>
        <translation>Sforzo di taglio</translation>
    </message>
    <message>
        <source>Twisted</source>
        <translation>Torsione</translation>
    </message>
    <message>
        <source>So slender that it may buckle before it breaks.</source>
        <translation>Così snella che può piegarsi di colpo prima di rompersi.</translation>
    </message>
    <message>
        <source>Uncertain: forces act beside the holes that it crosses.</source>
        <translation>Incerto: agiscono forze accanto ai fori che attraversa.</translation>
    </message>
    <message>
        <source>A rough figure: the neck is too short, or too near a force.</source>
        <translation>Un valore approssimativo: la strozzatura è troppo corta o troppo vicina a una forza.</translation>
    </message>
    <message>
        <source>It would crack at its corner first.</source>
        <translation>Si creperebbe prima nell’angolo.</translation>
    </message>
    <message>
        <source>It would break straight across.</source>
        <translation>Si romperebbe di netto.</translation>
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
        <translation>Tensione</translation>
    </message>
    <message>
        <source>Safety factor %1</source>
        <extracomment>in the legend of stress: %1 is the safety factor, such as 2</extracomment>
        <translation>Fattore di sicurezza %1</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>Resistenza sconosciuta</translation>
    </message>
    <message>
        <source>Nothing above %1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>Nulla sopra il %1&#x202f;%</translation>
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
        <translation>Non sta in piedi; le tensioni non vengono mostrate.</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>Un incastro si sfila; le tensioni non vengono mostrate.</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>Non si è potuto calcolare se regge.</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message>
        <source>Looking for sections…</source>
        <translation>Ricerca di sezioni…</translation>
    </message>
    <message>
        <source>Making facets…</source>
        <translation>Sfaccettatura…</translation>
    </message>
    <message>
        <source>Unfolding…</source>
        <translation>Sviluppo…</translation>
    </message>
    <message>
        <source>Tracing %1…</source>
        <translation>Ricalco di %1…</translation>
    </message>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>%n sezione creata.</numerusform>
            <numerusform>%n sezioni create.</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the section to cut holes in first, or place the drawing on it.</source>
        <translation>Seleziona prima la sezione in cui tagliare i fori, oppure appoggiaci sopra il disegno.</translation>
    </message>
    <message>
        <source>Select the section to engrave first, or place the drawing on it.</source>
        <translation>Seleziona prima la sezione da incidere, oppure appoggiaci sopra il disegno.</translation>
    </message>
    <message>
        <source>Looking for planes…</source>
        <translation>Ricerca di piani…</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateSource</name>
    <message>
        <source>Its file</source>
        <translation>File</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>mancante</translation>
    </message>
    <message>
        <source>read each time</source>
        <translation>letto ogni volta</translation>
    </message>
    <message>
        <source>kept in the model</source>
        <translation>contenuto nel modello</translation>
    </message>
    <message>
        <source>Find its file…</source>
        <translation>Trova il suo file…</translation>
    </message>
    <message>
        <source>Read it from where its file is now; it lies where it lay</source>
        <translation>Leggilo da dove si trova ora il suo file; resta al suo posto</translation>
    </message>
    <message>
        <source>Link to its file…</source>
        <translation>Collega al suo file…</translation>
    </message>
    <message>
        <source>Leave it out of the model&apos;s file, which gets smaller, and read it from where it is each time</source>
        <translation>Lasciarlo fuori dal file del modello, che diventa più piccolo, e leggerlo ogni volta da dove si trova</translation>
    </message>
    <message>
        <source>Keep it in the model</source>
        <translation>Tienilo nel modello</translation>
    </message>
    <message>
        <source>Put it into the model&apos;s file, so that it is there on other computers</source>
        <translation>Mettilo nel file del modello, così c’è anche su altri computer</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateTools</name>
    <message>
        <source>Move, turn and scale it in the view, with handles or numbers</source>
        <translation>Sposta, ruota e scala il riferimento nella vista, con le maniglie o con i numeri</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>Con una linea</translation>
    </message>
    <message>
        <source>Draw a line over something in it whose length you know</source>
        <translation>Traccia una linea su qualcosa nel riferimento di cui conosci la lunghezza</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>Sposta e ruota</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>Riferimenti</translation>
    </message>
    <message>
        <source>Add template…</source>
        <translation>Aggiungi riferimento…</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections after it</source>
        <translation>Leggi una mesh, un’immagine o un disegno da cui ricavare sezioni</translation>
    </message>
    <message>
        <source>Add a mesh, a picture or a drawing, or drop or paste one. Sections that you draw snap to where their planes cut a mesh, and to the lines of a drawing in their plane.</source>
        <translation>Aggiungi una mesh, un’immagine o un disegno, oppure trascinali o incollali qui. Le sezioni che disegni si agganciano dove il loro piano taglia una mesh, e alle linee di un disegno nel loro piano.</translation>
    </message>
    <message>
        <source>F2 renames, Space hides, L locks, Del removes.</source>
        <translation>F2 rinomina, Spazio nasconde, L blocca, Canc rimuove.</translation>
    </message>
    <message>
        <source>Slices…</source>
        <translation>Fette…</translation>
    </message>
    <message>
        <source>Cut it into sections that follow it</source>
        <translation>Taglialo in sezioni che lo seguono</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>Collocazione e misura</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacità</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Estensione</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>sconosciuta</translation>
    </message>
    <message>
        <source>To the ground</source>
        <translation>Al suolo</translation>
    </message>
    <message>
        <source>Stand it on the ground</source>
        <translation>Mettilo sul suolo</translation>
    </message>
    <message>
        <source>Stand upright</source>
        <translation>Raddrizza</translation>
    </message>
    <message>
        <source>Lay it on its other side: what is up in it is up in the view</source>
        <translation>Giralo sull’altro lato: ciò che in esso è in alto sta in alto anche nella vista</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a name, %2 what it is</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 manca</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Sblocca</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Blocca</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Nascondi</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>X del suo centro</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>Y del suo centro</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>Z del suo centro</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>Turned about X, first</source>
        <translation>Ruotato attorno a X, per primo</translation>
    </message>
    <message>
        <source>Turned about Y, after X</source>
        <translation>Ruotato attorno a Y, dopo X</translation>
    </message>
    <message>
        <source>Turned about Z, last</source>
        <translation>Ruotato attorno a Z, per ultimo</translation>
    </message>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>Mesh, %n triangolo</numerusform>
            <numerusform>Mesh, %n triangoli</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture, %1 × %2 pixels</source>
        <extracomment>%1 and %2 are numbers of pixels</extracomment>
        <translation>Immagine, %1 × %2 pixel</translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>Disegno, %n linea</numerusform>
            <numerusform>Disegno, %n linee</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ThicknessField</name>
    <message>
        <source>Thickness</source>
        <translation>Spessore</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourCard</name>
    <message>
        <source>Skip this step</source>
        <translation>Salta questo passo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Termina la visita</translation>
    </message>
    <message>
        <source>Tour</source>
        <extracomment>%1 is the number of a step, %2 how many there are</extracomment>
        <translation>Visita guidata</translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation>Visita guidata, passo %1 di %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourGuide</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the model to turn it; roll the wheel to come nearer.</source>
        <translation>&lt;b&gt;Guardati attorno.&lt;/b&gt; Trascina accanto al modello per ruotarlo; con la rotella ti avvicini.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Cut it.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; shows the sheets and writes the file for the cutter.</source>
        <translation>&lt;b&gt;Taglialo.&lt;/b&gt; &lt;b&gt;Esporta…&lt;/b&gt; mostra le lastre e scrive il file per la macchina da taglio.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a body.&lt;/b&gt; Press in the middle of the view and draw its outline in one go, flat along the top, down to the ground.</source>
        <translation>&lt;b&gt;Disegna un corpo.&lt;/b&gt; Premi in mezzo alla vista e traccia il suo contorno in un solo tratto, piatto in alto, fino al suolo.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a section across it.&lt;/b&gt; Press inside the body and drag out across its edge. Keep the button down: the view turns. Then draw the outline, down to the ground again.</source>
        <translation>&lt;b&gt;Disegna una sezione di traverso.&lt;/b&gt; Premi dentro il corpo e trascina fuori oltre il bordo. Tieni premuto il pulsante: la vista gira. Poi traccia il contorno, di nuovo fino al suolo.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Measure your sheet.&lt;/b&gt; Click the stock at the right of the tool bar, then its thickness, and type what you measured: all slits follow.</source>
        <translation>&lt;b&gt;Misura la tua lastra.&lt;/b&gt; Fai clic sul materiale a destra nella barra degli strumenti, poi sul suo spessore, e scrivi ciò che hai misurato: tutte le fessure lo seguono.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Will it work?&lt;/b&gt; The badges over the view tell you. Click one to read more.</source>
        <translation>&lt;b&gt;Funzionerà?&lt;/b&gt; Te lo dicono i bollini sopra la vista. Fai clic su uno per saperne di più.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Repeat it.&lt;/b&gt; Choose &lt;b&gt;Linear&lt;/b&gt;, click the section that you drew across, then the body: copies stand in a row along it.</source>
        <translation>&lt;b&gt;Ripetila.&lt;/b&gt; Scegli &lt;b&gt;Fila&lt;/b&gt;, fai clic sulla sezione di traverso, poi sul corpo: le copie stanno in fila lungo di esso.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That was all of the way,&lt;/b&gt; from the first stroke to the file. What is red has links under Checks that fix it. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;Questa era tutta la strada,&lt;/b&gt; dal primo tratto al file. Ciò che è rosso ha collegamenti in Controlli che lo sistemano. Premi &lt;b&gt;F1&lt;/b&gt; per saperne di più.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nearly.&lt;/b&gt; Drag the round handle at the end of the row back until no badge is red; then &lt;b&gt;Export…&lt;/b&gt; writes the file for the cutter.</source>
        <translation>&lt;b&gt;Quasi.&lt;/b&gt; Trascina indietro la maniglia rotonda alla fine della fila finché nessun bollino è rosso; poi &lt;b&gt;Esporta…&lt;/b&gt; scrive il file per la macchina da taglio.</translation>
    </message>
    <message>
        <source>&lt;b&gt;That one is very small.&lt;/b&gt; Undo it, then draw it larger, about half as wide as the view.</source>
        <translation>&lt;b&gt;È molto piccolo.&lt;/b&gt; Annulla e disegnalo più grande, largo circa metà della vista.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The tour ends here.&lt;/b&gt; You can take it again from the &lt;b&gt;Help&lt;/b&gt; menu. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;La visita guidata finisce qui.&lt;/b&gt; Puoi rifarla dal menu &lt;b&gt;Aiuto&lt;/b&gt;. Premi &lt;b&gt;F1&lt;/b&gt; per saperne di più.</translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message>
        <source>Unsaved work cannot be backed up in case of a crash. Save it to be safe.</source>
        <translation>Non si può fare una copia di riserva del lavoro non salvato in caso di blocco. Salvalo per sicurezza.</translation>
    </message>
    <message>
        <source>This work was opened or discarded in another window.</source>
        <translation>Questo lavoro è stato aperto o scartato in un’altra finestra.</translation>
    </message>
    <message>
        <source>The backup could not be opened: %1.</source>
        <translation>Impossibile aprire la copia di riserva: %1.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>senza nome</translation>
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
            <numerusform>%n passi</numerusform>
        </translation>
    </message>
    <message>
        <source>A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.</source>
        <translation>Una copia di lavoro non salvato è di una versione più recente di FlatFitFab; è conservata come %1.</translation>
    </message>
    <message>
        <source>A copy of unsaved work could not be read; it is kept as %1.</source>
        <translation>Non si è potuta leggere una copia di lavoro non salvato; è conservata come %1.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueDetails</name>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Numero intero</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Rapporto</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numero</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Sì o no</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Scelta</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Testo</translation>
    </message>
    <message>
        <source>small</source>
        <translation>piccolo</translation>
    </message>
    <message>
        <source>large</source>
        <translation>grande</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Scelte</translation>
    </message>
    <message>
        <source>small | large</source>
        <comment>an example of choices</comment>
        <translation>piccolo | grande</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Si ricava da</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppo</translation>
    </message>
    <message>
        <source>heading above it</source>
        <translation>titolo che gli sta sopra</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>what it is for</source>
        <translation>a che cosa serve</translation>
    </message>
    <message>
        <source>This cannot be read as what is needed here.</source>
        <translation>Questo non si può leggere come ciò che serve qui.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimo</translation>
    </message>
    <message>
        <source>any</source>
        <translation>qualsiasi</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Massimo</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Others can adjust it</source>
        <translation>Altri lo possono regolare</translation>
    </message>
    <message>
        <source>It can be set where the design is shared for adjusting</source>
        <translation>Si può impostare dove il progetto è condiviso da adattare</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>What is made of it becomes plain numbers</source>
        <translation>Ciò che ne dipende diventa un numero semplice</translation>
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
        <translation>Nome del valore</translation>
    </message>
    <message>
        <source>Kind, range and note</source>
        <translation>Tipo, intervallo e nota</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRows</name>
    <message>
        <source>Only for you</source>
        <translation>Solo per te</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message>
        <source>The range is narrower now of: %1.</source>
        <extracomment>%1 are names of values: &quot;width, boards&quot;</extracomment>
        <translation>Ora è più stretto l’intervallo di: %1.</translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>%n variante provata: va bene.</numerusform>
            <numerusform>Tutte le %n varianti provate vanno bene.</numerusform>
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
            <numerusform>%1 su %n variante non va bene: %2.</numerusform>
            <numerusform>%1 su %n varianti non vanno bene: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 corners %2 were tried.</source>
        <translation>Su %1 estremi ne sono stati provati %2.</translation>
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
            <numerusform>e %n altro</numerusform>
            <numerusform>e altri %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Trying the ranges… %1 %</source>
        <translation>Prova degli intervalli… %1 %</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ferma</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Riprova</translation>
    </message>
    <message>
        <source>Try all ranges</source>
        <translation>Prova tutti gli intervalli</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>Restringi gli intervalli</translation>
    </message>
    <message>
        <source>Says where in the ranges of the shown values the model cannot be assembled, breaks, falls over or does not fit.</source>
        <translation>Dice dove, negli intervalli dei valori mostrati, il modello non si può montare, si rompe, si ribalta o non entra nella lastra.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValuesDock</name>
    <message>
        <source>Values</source>
        <translation>Valori</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nuovo valore</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>the name of a new value, one word of letters</extracomment>
        <translation>valore</translation>
    </message>
    <message>
        <source>This design is made to be adjusted: set its values, then export it. Drag in the view to turn it.</source>
        <translation>Questo progetto è fatto per essere adattato: imposta i suoi valori, poi esportalo. Trascina nella vista per ruotarlo.</translation>
    </message>
    <message>
        <source>It is cut from %1.</source>
        <translation>Si taglia da %1.</translation>
    </message>
    <message>
        <source>There is nothing to adjust in this design.</source>
        <translation>In questo progetto non c’è nulla da adattare.</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>Modifica il progetto</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>Condividi da adattare</translation>
    </message>
    <message>
        <source>Bring back drawing and all panels; when it is saved now, the file opens like that.</source>
        <translation>Fa tornare il disegno e tutti i pannelli; se lo salvi ora, il file si apre così.</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else.</source>
        <translation>Chi apre il modello salvato vede la vista, i valori mostrati ed Esporta, e nient’altro.</translation>
    </message>
    <message>
        <source>Give a number a name: any field can use it, also in sums such as = 2*gap.</source>
        <translation>Dai un nome a un numero: ogni campo può usarlo, anche in calcoli come = 2*spazio.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewChips</name>
    <message>
        <source>How the model is shown</source>
        <translation>Come viene mostrato il modello</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Raggi X</translation>
    </message>
    <message>
        <source>Click to see the sections as they are again.</source>
        <translation>Fai clic per rivedere le sezioni come sono.</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>Spaccato</translation>
    </message>
    <message>
        <source>Click to see the whole model again.</source>
        <translation>Fai clic per rivedere tutto il modello.</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewCube</name>
    <message>
        <source>TOP</source>
        <comment>a face of the view cube: short</comment>
        <translation>ALTO</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <comment>a face of the view cube: short</comment>
        <translation>BASSO</translation>
    </message>
    <message>
        <source>FRONT</source>
        <comment>a face of the view cube: short</comment>
        <translation>FRONTE</translation>
    </message>
    <message>
        <source>BACK</source>
        <comment>a face of the view cube: short</comment>
        <translation>RETRO</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <comment>a face of the view cube: short</comment>
        <translation>DESTRA</translation>
    </message>
    <message>
        <source>LEFT</source>
        <comment>a face of the view cube: short</comment>
        <translation>SINISTRA</translation>
    </message>
</context>
<context>
    <name>fff::ui::Viewport</name>
    <message>
        <source>View of the model</source>
        <translation>Vista del modello</translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation>Disegna con il tasto sinistro del mouse, ruota con il destro.</translation>
    </message>
</context>
<context>
    <name>fff::ui::Workshop</name>
    <message>
        <source>%1 for the workshop</source>
        <extracomment>%1 is a model&apos;s name: what a folder of its files for a workshop is called</extracomment>
        <translation>%1 per il laboratorio</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>I passi non sono tra i file: %1</translation>
    </message>
    <message>
        <source>Where to put the folder “%1”</source>
        <translation>Dove mettere la cartella “%1”</translation>
    </message>
    <message>
        <source>Put it here</source>
        <translation>Mettila qui</translation>
    </message>
    <message>
        <source>no picture can be made on this display.</source>
        <translation>su questo schermo non si può creare nessuna immagine.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation>Disegna pezzi piatti in 3D e li taglia.</translation>
    </message>
    <message>
        <source>Models to open, each in a window; drawings, meshes and pictures to add to a new one.</source>
        <translation>Modelli da aprire, ciascuno in una finestra; disegni, mesh e immagini da aggiungere a uno nuovo.</translation>
    </message>
    <message>
        <source>Opens FILE as a copy: saving asks for a name.</source>
        <translation>Apre FILE come copia: salvando chiede un nome.</translation>
    </message>
    <message>
        <source>Plays a script of presses and moves.</source>
        <translation>Riproduce uno script di pressioni e movimenti.</translation>
    </message>
    <message>
        <source>SCRIPT</source>
        <translation>SCRIPT</translation>
    </message>
    <message>
        <source>Starts without what was set, and keeps no settings.</source>
        <translation>Parte senza ciò che era impostato e non conserva impostazioni.</translation>
    </message>
</context>
</TS>
