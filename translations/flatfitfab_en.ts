<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>%n part</numerusform>
            <numerusform>%n parts as one</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>%n other</numerusform>
            <numerusform>%n others</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>No steps to show: the model cannot be assembled, since %n section blocks itself.</numerusform>
            <numerusform>No steps to show: the model cannot be assembled, since %n sections block each other.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>%n joint</numerusform>
            <numerusform>%n joints</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n sheet</numerusform>
            <numerusform>%n sheets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n part</numerusform>
            <numerusform>%n parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>Can be assembled. %n step.</numerusform>
            <numerusform>Can be assembled. %n steps.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>Slits cut %n chip under 1 mm² off %1. It is waste and gets no number.</numerusform>
            <numerusform>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>%n section moved</numerusform>
            <numerusform>%n sections moved</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>%n section added</numerusform>
            <numerusform>%n sections added</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>%n section deleted</numerusform>
            <numerusform>%n sections deleted</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>%n problem solved</numerusform>
            <numerusform>%n problems solved</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>The slits of %n joint meet elsewhere</numerusform>
            <numerusform>The slits of %n joints meet elsewhere</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>1 joint flipped.</numerusform>
            <numerusform>%n joints flipped.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>A pair of sections only touches: they overlap by less than %1.</numerusform>
            <numerusform>%n pairs of sections only touch: they overlap by less than %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>1 joint flipped</numerusform>
            <numerusform>%n joints flipped</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>1 section reshaped</numerusform>
            <numerusform>%n sections reshaped</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>Can be assembled. But nothing holds %n of the parts.</numerusform>
            <numerusform>Can be assembled. But nothing holds %n of the parts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>%n new remark</numerusform>
            <numerusform>%n new remarks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>Cannot be assembled yet. It could be if %n pair of sections did not overlap.</numerusform>
            <numerusform>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>1 section moved down by %1</numerusform>
            <numerusform>%n sections moved down by %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>1 section moved up by %1</numerusform>
            <numerusform>%n sections moved up by %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections turned</source>
        <translation>
            <numerusform>1 section turned</numerusform>
            <numerusform>%n sections turned</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>Sections are joined in %n ring: put them together in the order of the steps.</numerusform>
            <numerusform>Sections are joined in %n rings: put them together in the order of the steps.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>Sections are joined in %n ring: whichever goes in last has to slide onto two others at once.</numerusform>
            <numerusform>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>%n new joint</numerusform>
            <numerusform>%n new joints</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>At most %n sheet</numerusform>
            <numerusform>At most %n sheets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>May run out of sheets. It takes up to %n sheet of %1, and you have %2.</numerusform>
            <numerusform>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>1 section was slightly skewed and has been straightened.</numerusform>
            <numerusform>%n sections were slightly skewed and have been straightened.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>1 contour crossed itself; its largest loop was kept.</numerusform>
            <numerusform>%n contours crossed themselves; the largest loop of each was kept.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>1 hole reached beyond its contour and was left out.</numerusform>
            <numerusform>%n holes reached beyond their contours and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>1 hole had no area and was left out.</numerusform>
            <numerusform>%n holes had no area and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>Holes of 1 section overlapped and were merged.</numerusform>
            <numerusform>Holes of %n sections overlapped and were merged.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>1 hole reached beyond its contour and was cut out of it.</numerusform>
            <numerusform>%n holes reached beyond their contours and were cut out of them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>Text after the last section was ignored in 1 place.</numerusform>
            <numerusform>Text after the last section was ignored in %n places.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>1 picture or mesh could not be read and was left out.</numerusform>
            <numerusform>%n pictures or meshes could not be read and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>1 template could not be read; its place was kept.</numerusform>
            <numerusform>%n templates could not be read; their places were kept.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n number no longer follows what was typed for it.</numerusform>
            <numerusform>%n numbers no longer follow what was typed for them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Hint</name>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%n outline of %1 did not fit and was left out.</numerusform>
            <numerusform>%n outlines of %1 did not fit and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n texts</source>
        <translation>
            <numerusform>%n text</numerusform>
            <numerusform>%n texts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures</source>
        <translation>
            <numerusform>%n picture</numerusform>
            <numerusform>%n pictures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>%n line was read</numerusform>
            <numerusform>%n lines were read</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copy like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</numerusform>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</numerusform>
            <numerusform>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 has 1 outline, which is too many: trace it coarser, or smooth it first.</numerusform>
            <numerusform>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>%n that was made of it is a plain number now.</numerusform>
            <numerusform>%n that were made of it are plain numbers now.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>Fold along the scored lines, then join edges with the same number: %n seam.</numerusform>
            <numerusform>Fold along the scored lines, then join edges with the same number: %n seams.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>%n preset that sets nothing else is gone with it.</numerusform>
            <numerusform>%n presets that set nothing else are gone with it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n edge has no fingers: its sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</numerusform>
            <numerusform>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>1 face was left out: a corner of it is not there.</numerusform>
            <numerusform>%n faces were left out: a corner of theirs is not there.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>1 face was left out: the place of a corner is no number.</numerusform>
            <numerusform>%n faces were left out: the place of a corner is no number.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>1 face was left out: it has a corner twice.</numerusform>
            <numerusform>%n faces were left out: they have a corner twice.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>1 face was left out: it is there twice.</numerusform>
            <numerusform>%n faces were left out: they are there twice.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>1 face looked the wrong way and was turned over.</numerusform>
            <numerusform>%n faces looked the wrong way and were turned over.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>The surface has a hole: 1 edge is open.</numerusform>
            <numerusform>The surface has holes: %n edges are open.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>More than two faces meet at 1 edge.</numerusform>
            <numerusform>More than two faces meet at %n edges.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>At 1 edge faces meet that cannot look the same way.</numerusform>
            <numerusform>At %n edges faces meet that cannot look the same way.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>1 gap in the cut was closed by a smooth curve.</numerusform>
            <numerusform>%n gaps in the cut were closed by smooth curves.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>OperationNotice</name>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1 stopped at %n section.</numerusform>
            <numerusform>%1 stopped at %n sections.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>%n section of %1 was left out, as there is nothing to hold it.</numerusform>
            <numerusform>%n sections of %1 were left out, as there is nothing to hold them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>1 small piece of %1 was left out.</numerusform>
            <numerusform>%n small pieces of %1 were left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Change stock of %n sections</numerusform>
            <numerusform>Change stock of %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>Move %n section to %1</numerusform>
            <numerusform>Move %n sections to %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>Stretch %n section to the ground</numerusform>
            <numerusform>Stretch %n sections to the ground</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>Delete %n point of %1</numerusform>
            <numerusform>Delete %n points of %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>Move %n point of %1</numerusform>
            <numerusform>Move %n points of %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>Change %n point of %1</numerusform>
            <numerusform>Change %n points of %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>Move %n sections</numerusform>
            <numerusform>Move %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Turn %n sections</source>
        <translation>
            <numerusform>Turn %n section</numerusform>
            <numerusform>Turn %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>Scale %n section</numerusform>
            <numerusform>Scale %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Copy %n sections</source>
        <translation>
            <numerusform>Copy %n section</numerusform>
            <numerusform>Copy %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>Mirror a copy of %n section</numerusform>
            <numerusform>Mirror copies of %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>Make %n section orthogonal</numerusform>
            <numerusform>Make %n sections orthogonal</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>Align %n section to an axis</numerusform>
            <numerusform>Align %n sections to an axis</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>Free %n section</numerusform>
            <numerusform>Free %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Lock %n sections</source>
        <translation>
            <numerusform>Lock %n section</numerusform>
            <numerusform>Lock %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n sections</source>
        <translation>
            <numerusform>Unlock %n section</numerusform>
            <numerusform>Unlock %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>Delete %n sections</numerusform>
            <numerusform>Delete %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>Leave out %n sections</numerusform>
            <numerusform>Leave out %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>Cut %n section</numerusform>
            <numerusform>Cut %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>Paste %n section</numerusform>
            <numerusform>Paste %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>Remove holes of %n section</numerusform>
            <numerusform>Remove holes of %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>Keep %n section symmetric</numerusform>
            <numerusform>Keep %n sections symmetric</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>Let the halves of %n section differ</numerusform>
            <numerusform>Let the halves of %n sections differ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>Attach 1 section</numerusform>
            <numerusform>Attach %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Suggest a section for %1</numerusform>
            <numerusform>Suggest %n sections for %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>Pull templates to %n section</numerusform>
            <numerusform>Pull templates to %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>Release templates from %n section</numerusform>
            <numerusform>Release templates from %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>Pin %n part</numerusform>
            <numerusform>Pin %n parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>Unpin %n section</numerusform>
            <numerusform>Unpin %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>Change rotation of %n section</numerusform>
            <numerusform>Change rotation of %n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>Change how %n section follows</numerusform>
            <numerusform>Change how %n sections follow</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>Only %n section of %1 was found: any more would be in the way of it, or be held by none.</numerusform>
            <numerusform>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%n section of %1 is the fewest that was found to stand.</numerusform>
            <numerusform>%n sections of %1 are the fewest that were found to stand.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>1 text was left out.</numerusform>
            <numerusform>%n texts were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>1 picture was left out.</numerusform>
            <numerusform>%n pictures were left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n minute ago</numerusform>
            <numerusform>%n minutes ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n hour ago</numerusform>
            <numerusform>%n hours ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>%n day ago</numerusform>
            <numerusform>%n days ago</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ChecksDock</name>
    <message numerus="yes">
        <source>%1 in %n places</source>
        <extracomment>%1 is what is wrong, such as &quot;Sections overlap&quot;</extracomment>
        <translation>
            <numerusform>%1 in %n place</numerusform>
            <numerusform>%1 in %n places</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>about %n min</numerusform>
            <numerusform>about %n min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>%n offcut is used up first.</numerusform>
            <numerusform>%n offcuts are used up first.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>%1 of %n offcut used up first.</numerusform>
            <numerusform>%1 of %n offcuts used up first.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n part</numerusform>
            <numerusform>%n parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>%n sheet</numerusform>
            <numerusform>%n sheets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>Exported the skin to %1; %n place stays open.</numerusform>
            <numerusform>Exported the skin to %1; %n places stay open.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>It takes %n more sheet of %1 than there are.</numerusform>
            <numerusform>It takes %n more sheets of %1 than there are.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>%n joint pulled open, up to %1&#x202f;N</numerusform>
            <numerusform>%n joints pulled open, up to %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::LibraryDock</name>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>Recovered: %n model that were not saved</numerusform>
            <numerusform>Recovered: %n models that were not saved</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>And %n more.</numerusform>
            <numerusform>And %n more.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1, and %n more here</numerusform>
            <numerusform>%1, and %n more here</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>%n more in Checks.</numerusform>
            <numerusform>%n more in Checks.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesHeader</name>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n joint</numerusform>
            <numerusform>%n joints</numerusform>
        </translation>
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
    <name>fff::ui::ReplaceQuestion</name>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>Replace %n existing file?</numerusform>
            <numerusform>Replace %n existing files?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 and %n more are too large for their sheets.</numerusform>
            <numerusform>%1 and %n more are too large for their sheets.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>%n pinned part had no room where it was.</numerusform>
            <numerusform>%n pinned parts had no room where they were.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>%n sheet more than there are</numerusform>
            <numerusform>%n sheets more than there are</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · %n part · %1 % used</numerusform>
            <numerusform> · %n parts · %1 % used</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>%n patch</numerusform>
            <numerusform>%n patches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1; %n place stays open.</numerusform>
            <numerusform>%1; %n places stay open.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>%n section selected</numerusform>
            <numerusform>%n sections selected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n part</numerusform>
            <numerusform>%n parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n sheet</numerusform>
            <numerusform>%n sheets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StockFields</name>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>Make its %n section of</numerusform>
            <numerusform>Make its %n sections of</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>Made %n section.</numerusform>
            <numerusform>Made %n sections.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>Mesh, %n triangle</numerusform>
            <numerusform>Mesh, %n triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>Drawing, %n line</numerusform>
            <numerusform>Drawing, %n lines</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message numerus="yes">
        <source>and %n other(s)</source>
        <translation>
            <numerusform>and %n other</numerusform>
            <numerusform>and %n others</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>The one variant that was tried is good.</numerusform>
            <numerusform>All %n variants that were tried are good.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n variant(s) fail: %2.</source>
        <extracomment>%1 is a number, %2 a list such as &quot;Falls over (5), Breaks (2)&quot;</extracomment>
        <translation>
            <numerusform>%1 of %n variant fails: %2.</numerusform>
            <numerusform>%1 of %n variants fail: %2.</numerusform>
        </translation>
    </message>
</context>
</TS>
