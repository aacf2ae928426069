<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>SceneText</name>
    <message numerus="yes">
        <source> · %n leakage taps</source>
        <translation>
            <numerusform> · %n leakage tap</numerusform>
            <numerusform> · %n leakage taps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hogelscope::FileCommands</name>
    <message numerus="yes">
        <source>Session · %n states</source>
        <translation>
            <numerusform>Session · %n state</numerusform>
            <numerusform>Session · %n states</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hogelscope::ImageCommands</name>
    <message numerus="yes">
        <source>coarse: %n samples of the pupil</source>
        <translation>
            <numerusform>coarse: %n sample of the pupil</numerusform>
            <numerusform>coarse: %n samples of the pupil</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hogelscope::Messages</name>
    <message numerus="yes">
        <source>⚠ %n errors</source>
        <translation>
            <numerusform>⚠ %n error</numerusform>
            <numerusform>⚠ %n errors</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hogelscope::Properties</name>
    <message numerus="yes">
        <source>%1 · %n rays</source>
        <translation>
            <numerusform>%1 · %n ray</numerusform>
            <numerusform>%1 · %n rays</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hogelscope::ReportDock</name>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt; %n states</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt; %n state</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt; %n states</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Replace report of %n states</source>
        <translation>
            <numerusform>Replace report of %n state</numerusform>
            <numerusform>Replace report of %n states</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hogelscope::SessionModel</name>
    <message numerus="yes">
        <source>Change %1 of %n states</source>
        <translation>
            <numerusform>Change %1</numerusform>
            <numerusform>Change %1 of %n states</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hogelscope::StateCommands</name>
    <message numerus="yes">
        <source>Delete %n states</source>
        <translation>
            <numerusform>Delete state</numerusform>
            <numerusform>Delete %n states</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n states</source>
        <translation>
            <numerusform>Move state</numerusform>
            <numerusform>Move %n states</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Added %n states to %1</source>
        <translation>
            <numerusform>Added %n state to %1</numerusform>
            <numerusform>Added %n states to %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hogelscope::ViewOutput</name>
    <message numerus="yes">
        <source>Saved %n pictures in %1</source>
        <translation>
            <numerusform>Saved %n picture in %1</numerusform>
            <numerusform>Saved %n pictures in %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>hogelscope::ViewWorker</name>
    <message numerus="yes">
        <source>, %n threads</source>
        <translation>
            <numerusform>, %n thread</numerusform>
            <numerusform>, %n threads</numerusform>
        </translation>
    </message>
</context>
</TS>
