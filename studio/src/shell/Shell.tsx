import { Inspector } from '../inspector/Inspector';
import { Outline } from '../outline/Outline';
import { send } from '../connection/socket';
import { KeysPanel } from '../panels/KeysPanel';
import {
    connection, deferred, hasErrors, isDeferred, isStale, notice, panel, problems, timeline, work,
} from '../state/state';
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

/// How many problems there are, in words; empty if there are none.
function problemCount(): string {
    const list = problems.value?.list ?? [];
    const errors = list.filter((problem) => problem.severity === 'error').length;
    const words = (count: number, one: string) =>
        count === 0 ? [] : [`${count} ${one}${count === 1 ? '' : 's'}`];
    return [...words(errors, 'error'), ...words(list.length - errors, 'warning')].join(', ');
}

/// What the server works on, or waits for.
function Simulation() {
    const waits = deferred.value;
    if (waits && isDeferred.value && waits.reason === 'limit') {
        return (
            <span>
                {waits.message}{' '}
                <button class="link" onClick={() => send('simulate', { v: waits.v })}>Simulate</button>
            </span>
        );
    }
    if (work.value?.what) {
        return <span>simulating: {Math.round(100 * work.value.fraction)} %</span>;
    }
    const head = timeline.value?.head;
    return head && !isStale.value
        ? <span>{head.kept ? 'motion kept' : `simulated in ${Math.round(head.milliseconds)} ms`}</span>
        : null;
}

function Status() {
    return (
        <footer class="status" role="status">
            <span class={notice.value?.kind === 'error' ? 'error' : ''}>{notice.value?.text}</span>
            {connection.value === 'lost'
                ? <button class="link" onClick={copyText}>Copy text</button> : null}
            <span class="spring" />
            <span class={hasErrors.value ? 'error' : ''}>{problemCount()}</span>
            <Simulation />
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
            {panel.value === 'keys' ? <KeysPanel /> : null}
        </div>
    );
}
