import { DocumentsPanel } from '../documents/DocumentsPanel';
import { FilmPanel } from '../films/FilmPanel';
import { Inspector } from '../inspector/Inspector';
import { Outline } from '../outline/Outline';
import { SceneList } from '../outline/SceneList';
import { KeysPanel } from '../panels/KeysPanel';
import { Palette } from '../panels/Palette';
import { SequenceView } from '../sequence/SequenceView';
import { isSequence, panel } from '../state/state';
import { TimeStrip } from '../strip/TimeStrip';
import { TextEditor } from '../text/TextEditor';
import { View } from '../view/View';
import { inspectorArea, outlineArea, stripArea, textArea } from './layout';
import { Splitter } from './Splitter';
import { LostConnection, Status } from './Status';
import { Toolbar } from './Toolbar';
import { useShellCommands } from './commands';
import './shell.css';

/// The whole page of an open shot.
export function Shell() {
    useShellCommands();
    const outline = outlineArea.size.value;
    const text = textArea.size.value;
    const strip = stripArea.size.value;
    return (
        <div class="shell">
            <Toolbar />
            <LostConnection />
            <div class="work">
                <nav class="side" style={{ width: outline }} hidden={outline === 0}
                    aria-label="Outline and inspector">
                    <div class="fill"><Outline /></div>
                    <Splitter area={inspectorArea} label="Height of the inspector" isLevel isAfter />
                    <div style={{ height: inspectorArea.size.value }} class="fixed"><Inspector /></div>
                </nav>
                <Splitter area={outlineArea} label="Width of the outline" />
                <main class="middle">
                    <div class="fill">{isSequence.value ? <SequenceView /> : <><View /><SceneList /></>}</div>
                    <Splitter area={stripArea} label="Height of the time strip" isLevel isAfter />
                    <div class="fixed" style={{ height: strip }}><TimeStrip /></div>
                </main>
                <Splitter area={textArea} label="Width of the text" isAfter />
                <aside class="side" style={{ width: text }} hidden={text === 0} aria-label="Text">
                    <TextEditor />
                </aside>
            </div>
            <Status />
            {panel.value === 'keys' ? <KeysPanel /> : null}
            {panel.value === 'film' ? <FilmPanel /> : null}
            {panel.value === 'documents' ? <DocumentsPanel /> : null}
            {panel.value === 'palette' ? <Palette /> : null}
        </div>
    );
}
