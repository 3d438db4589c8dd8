import {
    CircleHelp, Clapperboard, Map as MapIcon, Moon, PanelLeft, PanelRight, Redo2, Save, Sun, TriangleAlert, Undo2,
    type LucideIcon,
} from 'lucide-preact';
import { panel, problems, sequence, shot, welcome } from '../state/state';
import { openDocuments } from '../documents/documents_state';
import { film, isMaking } from '../films/film_state';
import { hintOf } from '../state/keys';
import { buffers, isChanged } from '../text/buffers';
import { saveAll } from '../text/saving';
import { FileMenu } from '../start/FileMenu';
import { showRange } from '../text/show';
import { redoable, redoTitle, undoable, undoTitle } from '../text/steps';
import { undoStep } from '../text/undo_commands';
import { outlineArea, textArea, toggle } from './layout';
import { shownTheme, switchTheme } from './theme';

interface ToolProperties {
    icon: LucideIcon;
    label: string;
    onClick(): void;
    isPressed?: boolean;
    isDisabled?: boolean;
    text?: string;
}

function Tool({ icon: Icon, label, onClick, isPressed, isDisabled, text }: ToolProperties) {
    return (
        <button class="tool" title={label} aria-label={label} aria-pressed={isPressed}
            disabled={isDisabled} onClick={onClick}>
            <Icon size={17} strokeWidth={1.75} aria-hidden="true" />
            {text ? <span>{text}</span> : null}
        </button>
    );
}

function togglePanel(name: string): void {
    panel.value = panel.value === name ? null : name;
}

/// How far the film is, while one is being made.
function filmText(): string {
    const state = film.value;
    return state && isMaking.value && state.frames > 0
        ? `${Math.floor((100 * state.finished) / state.frames)} %` : '';
}

/// The line of tools above everything.
export function Toolbar() {
    const name = (shot.value ?? sequence.value)?.name ?? buffers.value[0]?.name ?? 'carom studio';
    const isDirty = buffers.value.some((buffer) => buffer.writable && isChanged(buffer));
    const count = problems.value?.list.length ?? 0;
    const first = problems.value?.list[0];
    const isDark = shownTheme.value === 'dark';
    return (
        <header class="toolbar">
            <Tool icon={PanelLeft} label="Outline" isPressed={outlineArea.size.value > 0}
                onClick={() => toggle(outlineArea)} />
            <FileMenu />
            <h1 title={welcome.value?.shot}>{name}</h1>
            {isDirty ? <span class="dirty" title="There are unsaved changes" /> : null}
            <div class="group">
                <Tool icon={Undo2} label={`${undoTitle.value} (Ctrl+Z)`}
                    isDisabled={undoable.value.length === 0} onClick={() => undoStep(true)} />
                <Tool icon={Redo2} label={`${redoTitle.value} (Ctrl+Y)`}
                    isDisabled={redoable.value.length === 0} onClick={() => undoStep(false)} />
                <Tool icon={Save} label="Save (Ctrl+S)" isDisabled={!isDirty} onClick={saveAll} />
            </div>
            <div class="spring" />
            <div class="group">
                <Tool icon={MapIcon} label="Plan, report and contact sheet"
                    isPressed={panel.value === 'documents'} onClick={() => openDocuments('plan')} />
                <Tool icon={Clapperboard} label={hintOf('film')} isPressed={panel.value === 'film'}
                    text={filmText() || 'Film'} onClick={() => togglePanel('film')} />
            </div>
            <div class="group">
                <Tool icon={TriangleAlert} isDisabled={!first}
                    label={`Show the first problem${count > 0 ? ` of ${count}` : ''}`}
                    text={count > 0 ? String(count) : ''}
                    onClick={() => first && showRange(first.place)} />
                <Tool icon={isDark ? Sun : Moon}
                    label={isDark ? 'Switch to light' : 'Switch to dark'} onClick={switchTheme} />
                <Tool icon={CircleHelp} label="Keys (?)" isPressed={panel.value === 'keys'}
                    onClick={() => togglePanel('keys')} />
                <Tool icon={PanelRight} label="Text" isPressed={textArea.size.value > 0}
                    onClick={() => toggle(textArea)} />
            </div>
        </header>
    );
}
