import { Inspector } from '../inspector/Inspector';
import { Outline } from '../outline/Outline';
import { connection, notice } from '../state/state';
import { TimeStrip } from '../strip/TimeStrip';
import { activeFile, bufferOf, textOf } from '../text/buffers';
import { TextEditor } from '../text/TextEditor';
import { View } from '../view/View';
import { inspectorArea, outlineArea, stripArea, textArea } from './layout';
import { Splitter } from './Splitter';
import { Toolbar } from './Toolbar';
import './shell.css';

const kConnection = { connecting: 'connecting', open: 'connected', lost: 'connection lost' };

/// Puts the shown text on the clipboard, for when the server is gone.
function copyText(): void {
    const buffer = bufferOf(activeFile.value);
    if (buffer) {
        void navigator.clipboard.writeText(textOf(buffer)).then(() => {
            notice.value = { kind: 'info', text: `The text of ${buffer.name} is copied.` };
        });
    }
}

function Status() {
    return (
        <footer class="status" role="status">
            <span class={notice.value?.kind === 'error' ? 'error' : ''}>{notice.value?.text}</span>
            {connection.value === 'lost'
                ? <button class="link" onClick={copyText}>Copy text</button> : null}
            <span class={connection.value}>{kConnection[connection.value]}</span>
        </footer>
    );
}

/// The whole page of an open shot.
export function Shell() {
    const outline = outlineArea.size.value;
    const text = textArea.size.value;
    const strip = stripArea.size.value;
    return (
        <div class="shell">
            <Toolbar />
            <div class="work">
                <nav class="side" style={{ width: outline }} hidden={outline === 0}
                    aria-label="Outline and inspector">
                    <div class="fill"><Outline /></div>
                    <Splitter area={inspectorArea} label="Height of the inspector" isLevel isAfter />
                    <div style={{ height: inspectorArea.size.value }} class="fixed"><Inspector /></div>
                </nav>
                <Splitter area={outlineArea} label="Width of the outline" />
                <main class="middle">
                    <div class="fill"><View /></div>
                    <Splitter area={stripArea} label="Height of the time strip" isLevel isAfter />
                    <div class="fixed" style={{ height: strip }}><TimeStrip /></div>
                </main>
                <Splitter area={textArea} label="Width of the text" isAfter />
                <aside class="side" style={{ width: text }} hidden={text === 0} aria-label="Text">
                    <TextEditor />
                </aside>
            </div>
            <Status />
        </div>
    );
}
