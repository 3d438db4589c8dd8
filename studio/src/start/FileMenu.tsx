/// The menu of what can be done with files, in the toolbar.
import { ChevronDown } from 'lucide-preact';
import { send } from '../connection/socket';
import { runCommand } from '../state/keys';
import { start, welcome } from '../state/state';
import { openMenu, type MenuItem } from '../view/menu/menu_state';
import { saveAll } from '../text/saving';
import { addFromFile } from './AddParts';
import { closeShot, hasUnsaved, openShot } from './file_actions';
import { chooseScene } from './import_scene';
import { chooseShot } from './OpenShot';
import { saveAs } from './SaveAs';

const kMostRecent = 6;

/// What can be done with files, and the recent shots.
export function fileItems(): MenuItem[] {
    const recent = (start.value?.recent ?? [])
        .filter(({ file }) => file !== welcome.value?.shot).slice(0, kMostRecent);
    return [
        { label: 'New…', hint: 'templates, examples', run: () => { void closeShot(); } },
        { label: 'Open…', hint: 'Ctrl+O', run: () => { void chooseShot(); } },
        { label: 'Save', hint: 'Ctrl+S', startsGroup: true, isDisabled: !hasUnsaved(),
            run: saveAll },
        { label: 'Save as…', hint: 'Ctrl+Shift+S', run: saveAs },
        { label: 'Add from file…', startsGroup: true, run: () => { void addFromFile(); } },
        { label: 'Import a scene…', run: chooseScene },
        { label: 'Make a film…', hint: 'Ctrl+Enter', startsGroup: true,
            run: () => { runCommand('film'); } },
        { label: 'Plan, report, contact sheet…', run: () => { runCommand('showPlan'); } },
        { label: 'Export…', hint: 'Ctrl+Shift+E', run: () => { runCommand('export'); } },
        ...recent.map(({ name, file }, i) => ({
            label: name, startsGroup: i === 0, hint: i === 0 ? 'recent' : '',
            run: () => { void openShot(file); },
        })),
    ];
}

function show(button: HTMLElement): void {
    send('offer', {});  // the recent shots
    const { left, bottom } = button.getBoundingClientRect();
    openMenu({ title: 'File', x: left, y: bottom + 4, items: fileItems });
}

export function FileMenu() {
    return (
        <button type="button" class="tool" aria-haspopup="menu" title="New, open, save as, import"
            onClick={(event) => show(event.currentTarget)}>
            <span>File</span>
            <ChevronDown size={14} strokeWidth={1.75} aria-hidden="true" />
        </button>
    );
}
