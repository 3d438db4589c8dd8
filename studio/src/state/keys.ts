/// The keys of the page: one table, which the keys page shows, and one listener on the window. Parts
/// of the page say with `onCommand` what a command does.

import { hasOwnUndo, watchDrafts } from './drafts';

/// One command and the keys that give it. A key is written as "ctrl+shift+z": modifiers in the order
/// ctrl, alt, shift, then KeyboardEvent.key in lower case ("space" for the space bar). The command
/// key of a Mac counts as ctrl. For signs such as "?" shift is not written.
export interface KeyBinding {
    command: string;
    keys: readonly string[];
    group: 'Time' | 'View' | 'Selection' | 'Text' | 'Page';
    about: string;
    /// Works while a text field has the focus, too.
    everywhere?: boolean;
}

export const kKeyBindings = [
    { command: 'play', keys: ['space'], group: 'Time', about: 'Play or pause' },
    { command: 'returnToStart', keys: ['enter'], group: 'Time',
        about: 'Go back to where playback began' },
    { command: 'toStart', keys: ['home'], group: 'Time', about: 'Go to the start of the film' },
    { command: 'toEnd', keys: ['end'], group: 'Time', about: 'Go to the end of the film' },
    { command: 'frameBack', keys: ['arrowleft'], group: 'Time', about: 'One frame back' },
    { command: 'frameForward', keys: ['arrowright'], group: 'Time', about: 'One frame forward' },
    { command: 'tenBack', keys: ['shift+arrowleft'], group: 'Time', about: 'Ten frames back' },
    { command: 'tenForward', keys: ['shift+arrowright'], group: 'Time', about: 'Ten frames forward' },
    { command: 'tenthBack', keys: [','], group: 'Time', about: 'A tenth of a scene second back' },
    { command: 'tenthForward', keys: ['.'], group: 'Time', about: 'A tenth of a scene second forward' },
    { command: 'eventBack', keys: ['['], group: 'Time', about: 'Previous event' },
    { command: 'eventForward', keys: [']'], group: 'Time', about: 'Next event' },
    { command: 'loop', keys: ['l'], group: 'Time', about: 'Repeat the film' },
    { command: 'slower', keys: ['-'], group: 'Time', about: 'Play slower' },
    { command: 'faster', keys: ['+', '='], group: 'Time', about: 'Play faster' },
    { command: 'mute', keys: ['shift+m'], group: 'Time', about: 'Sound on or off' },
    { command: 'fitStrip', keys: ['shift+f'], group: 'Time', about: 'Show all times on the strip' },

    { command: 'frameSelection', keys: ['f'], group: 'View', about: 'Frame the selection' },
    { command: 'refine', keys: ['r'], group: 'View', about: 'Show the path-traced picture' },
    { command: 'lookThrough', keys: ['c'], group: 'View', about: 'Look through the film’s camera' },
    { command: 'viewTop', keys: ['1'], group: 'View', about: 'View from above' },
    { command: 'viewAboveCamera', keys: [], group: 'View',
        about: 'View from above the camera, turned as it is' },
    { command: 'viewSide', keys: ['2'], group: 'View', about: 'View from the side' },
    { command: 'viewFree', keys: ['3'], group: 'View', about: 'Free view' },
    { command: 'wireframe', keys: ['w'], group: 'View', about: 'Show edges only' },
    { command: 'pinGhost', keys: ['p', 'g'], group: 'View', about: 'Pin the paths for comparison' },
    { command: 'fan', keys: ['v'], group: 'View', about: 'Show eight slightly different runs' },

    { command: 'toolMove', keys: ['m'], group: 'Selection', about: 'Show the handles that move it' },
    { command: 'toolTurn', keys: ['e'], group: 'Selection', about: 'Show the rings that turn it' },
    { command: 'toolScale', keys: ['s'], group: 'Selection', about: 'Show the handles that resize it' },
    { command: 'delete', keys: ['delete'], group: 'Selection', about: 'Delete what is selected' },
    { command: 'duplicate', keys: ['ctrl+d'], group: 'Selection',
        about: 'Duplicate what is selected' },
    { command: 'showInText', keys: ['t'], group: 'Selection', about: 'Show it in the text' },
    { command: 'cancel', keys: ['escape'], group: 'Selection',
        about: 'Cancel a drag, or deselect' },

    { command: 'save', keys: ['ctrl+s'], group: 'Text', about: 'Save', everywhere: true },
    { command: 'saveAs', keys: ['ctrl+shift+s'], group: 'Text', about: 'Save under another name',
        everywhere: true },
    { command: 'open', keys: ['ctrl+o'], group: 'Text', about: 'Open another shot',
        everywhere: true },
    { command: 'undo', keys: ['ctrl+z'], group: 'Text', about: 'Undo' },
    { command: 'redo', keys: ['ctrl+y', 'ctrl+shift+z'], group: 'Text', about: 'Redo' },

    { command: 'keys', keys: ['?'], group: 'Page', about: 'Show the keys' },
    { command: 'problems', keys: ['ctrl+shift+m'], group: 'Page', about: 'Show the problems',
        everywhere: true },
    { command: 'search', keys: ['/'], group: 'Page', about: 'Search the outline' },
    { command: 'palette', keys: ['ctrl+k', 'ctrl+shift+p'], group: 'Page',
        about: 'Find a command, an object, or something to add', everywhere: true },
    { command: 'toggleOutline', keys: ['ctrl+b'], group: 'Page', about: 'Show or fold the outline',
        everywhere: true },
    { command: 'toggleText', keys: ['ctrl+j'], group: 'Page', about: 'Show or fold the text',
        everywhere: true },
    { command: 'nextArea', keys: ['f6'], group: 'Page',
        about: 'Go to the next area: outline, values, view, strip, text', everywhere: true },
    { command: 'previousArea', keys: ['shift+f6'], group: 'Page', about: 'Go to the previous area',
        everywhere: true },
    { command: 'film', keys: ['ctrl+enter'], group: 'Page', about: 'Make a film, and watch it',
        everywhere: true },
    { command: 'showPlan', keys: [], group: 'Page', about: 'Show the plan' },
    { command: 'showReport', keys: [], group: 'Page', about: 'Show the report' },
    { command: 'showPlot', keys: [], group: 'Page', about: 'Show speeds and energy' },
    { command: 'showContactSheet', keys: [], group: 'Page', about: 'Show the contact sheet' },
    { command: 'export', keys: ['ctrl+shift+e'], group: 'Page',
        about: 'Export the motion, the scene or a frame', everywhere: true },
    { command: 'switchTheme', keys: [], group: 'Page', about: 'Switch between dark and light' },
] as const satisfies readonly KeyBinding[];

export type Command = (typeof kKeyBindings)[number]['command'];

const actions = new Map<Command, (() => void)[]>();

/// Says what a command does. The latest one counts. Returns a function that takes it back.
export function onCommand(command: Command, action: () => void): () => void {
    const all = actions.get(command) ?? [];
    actions.set(command, all);
    all.push(action);
    return () => {
        const at = all.lastIndexOf(action);
        if (at >= 0) {
            all.splice(at, 1);
        }
    };
}

/// Does what a command is bound to. Returns false if nothing is.
export function runCommand(command: Command): boolean {
    const action = actions.get(command)?.at(-1);
    action?.();
    return action !== undefined;
}

/// Whether a command would do something now.
export function isBound(command: Command): boolean {
    return (actions.get(command)?.length ?? 0) > 0;
}

const kKeyWords: Readonly<Record<string, string>> = {
    arrowleft: '←', arrowright: '→', arrowup: '↑', arrowdown: '↓', ctrl: 'Ctrl', shift: 'Shift',
    alt: 'Alt', escape: 'Esc', delete: 'Del', space: 'Space', enter: 'Enter', home: 'Home', end: 'End', pageup: 'Page Up',
    pagedown: 'Page Down', arrows: 'Arrows',
};

/// A key of the table as people read it: ["Ctrl", "Shift", "Z"].
export function keyWords(key: string): string[] {
    const words = key === '+' ? ['+'] : key.split('+');
    return words.map((word) => kKeyWords[word] ?? word.toUpperCase());
}

/// The key of an event as the table writes it.
export function keyName(event: Pick<KeyboardEvent,
    'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>): string {
    const key = event.key === ' ' ? 'space' : event.key.toLowerCase();
    const isSign = key.length === 1 && !/[a-z]/.test(key);
    const words = [
        event.ctrlKey || event.metaKey ? 'ctrl' : '',
        event.altKey ? 'alt' : '',
        event.shiftKey && !isSign ? 'shift' : '',
        key,
    ];
    return words.filter((word) => word !== '').join('+');
}

/// What a command does and its first key, for tooltips: "Play or pause (Space)".
export function hintOf(command: Command): string {
    const binding = kKeyBindings.find((one) => one.command === command) as KeyBinding | undefined;
    const key = binding?.keys[0];
    return `${binding?.about ?? ''}${key ? ` (${keyWords(key).join('+')})` : ''}`;
}

const byKey = new Map<string, KeyBinding>(
    kKeyBindings.flatMap((binding: KeyBinding) => binding.keys.map((key) => [key, binding])),
);

/// The binding of a key as the table writes it.
export function bindingOf(key: string): KeyBinding | undefined {
    return byKey.get(key);
}

/// Elements that need the keys themselves: text fields, and lists that the arrow keys walk through.
const kTypes = 'input:not([type=checkbox]):not([type=range]), textarea, select, [contenteditable]';
const kUsesArrows = '[role=tree], [role=listbox], [role=menu], [role=tablist], [role=slider], '
    + '[role=spinbutton], input[type=range]';
const kUsesEnter = 'button, a[href], summary, [role=button], [role=menuitem], input[type=checkbox]';

/// Whether the element with the focus uses the key itself.
function isTaken(target: EventTarget | null, key: string, binding: KeyBinding): boolean {
    if (binding.everywhere || !(target instanceof Element)) {
        return false;
    }
    if (target.closest(kTypes)) {
        return (binding.command !== 'undo' && binding.command !== 'redo') || hasOwnUndo(target);
    }
    if (/arrow|home|end$/.test(key)) {
        return target.closest(kUsesArrows) !== null;
    }
    return (key === 'enter' || key === 'space')
        && target.closest(`${kUsesEnter}, [role=treeitem]`) !== null;
}

function onKeyDown(event: KeyboardEvent): void {
    const key = keyName(event);
    const binding = byKey.get(key);
    // An open dialog has all keys for itself, also Escape, which closes it.
    const isDialogOpen = document.querySelector('dialog:modal') !== null;
    if (!binding || event.defaultPrevented || event.isComposing || isDialogOpen
        || isTaken(event.target, key, binding)) {
        return;
    }
    if (runCommand(binding.command as Command)) {
        event.preventDefault();
    }
}

/// Listens to the keys of the whole page. Returns a function that ends this.
export function listenToKeys(): () => void {
    const stopDrafts = watchDrafts();
    window.addEventListener('keydown', onKeyDown);
    return () => {
        stopDrafts();
        window.removeEventListener('keydown', onKeyDown);
    };
}
