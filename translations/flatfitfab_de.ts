<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CommandLine</name>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is to be cut, in each section&apos;s own coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting files, true to size; or the model in the native format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs a script of what a person does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For machines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>a model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this value is not possible here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing here, expected %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a count that is not possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these control points make no closed contour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these control points make no closed contour: found %1, expected %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a part fits no sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>part %1 is too large: it measures %2, its sheet %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a model, expected a .fff file or a .txt file of FlatFab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these axes make no frame, expected two of length 1 at a right angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this refers to nothing that is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number %1 is given twice, expected one of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this number is given twice, expected one of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the axes of %1 were not at right angles or not of length 1 and have been straightened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the axes of a frame were not at right angles or not of length 1 and have been straightened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a contour of %1 crosses itself; its largest region was kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest region was kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a hole of %1 reaches out of its contour and was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a hole reaches out of its contour and was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the count in the header is not that of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three control points a segment, at least 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three control points a segment and the first again, at least 7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number, 0 or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point [x, y, z]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a colon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::SessionHost</name>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>%n Sektion löschen</numerusform>
            <numerusform>%n Sektionen löschen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>%n Sektion verschieben</numerusform>
            <numerusform>%n Sektionen verschieben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Material von %n Sektion ändern</numerusform>
            <numerusform>Material von %n Sektionen ändern</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::cli</name>
    <message>
        <source>There is no stock &quot;%1&quot;. Known are those of the file, Birch plywood and Acrylic.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts every section from this stock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play added to slits; negative presses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres a unit of a FlatFab file (25.4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number, at least %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Narrowest slit as drawn: %1 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>svg or fff, where the file&apos;s name does not tell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>-o is missing: the file to write.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is of no kind that can be written; expected .svg or .fff.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For machines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance of the chords from the curves (0.01).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>There is no step to take back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No step was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models (*.fff *.txt);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FlatFitFab models (*.fff)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export cutting files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawings for cutters (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be opened. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be saved. The file on disk is as it was before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation type="unfinished"></translation>
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
        <source>Exported %1 on %2 to %3; slits are drawn %4&#x202f;mm wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>untitled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::HintText</name>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn the view; middle drag moves it, the wheel zooms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. Esc cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turning to the new plane; move on when it stops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the grey zone where the contour shall begin. Release here cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. Esc cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. Esc cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept. Ctrl+Z undoes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made of this line. Draw it as one open loop.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::LengthEdit</name>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stock of the next section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undid “%1”. Ctrl+Shift+Z brings it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Did “%1” again. Ctrl+Z takes it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About FlatFitFab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;FlatFitFab %1&lt;/b&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::MeasureText</name>
    <message>
        <source>%1&#x202f;mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1&#x202f;kg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1&#x202f;g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1˼m²</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>Und %n weitere.</numerusform>
            <numerusform>Und %n weitere.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slit %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation type="unfinished"></translation>
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
            <numerusform>%n Sektion</numerusform>
            <numerusform>%n Sektionen</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n Sektion</numerusform>
            <numerusform>%n Sektionen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Stock</name>
    <message>
        <source>%1 %2&#x202f;mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use %1 for new sections</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>fff::ui::Viewport</name>
    <message>
        <source>View of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model to open.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>std</name>
    <message>
        <source>Sections: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no section.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
