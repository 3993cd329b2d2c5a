<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>fff::SessionHost</name>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>Delete %n sections</numerusform>
            <numerusform>Delete %n sections</numerusform>
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
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>Change stock of %n sections</numerusform>
            <numerusform>Change stock of %n sections</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
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
    <name>fff::ui::PropertiesDock</name>
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
    <name>fff::ui::StatusLine</name>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n section</numerusform>
            <numerusform>%n sections</numerusform>
        </translation>
    </message>
</context>
</TS>
