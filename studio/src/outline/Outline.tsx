import { signal } from '@preact/signals';
import { ChevronRight, Copy, Plus, Search, Trash2 } from 'lucide-preact';
import { useEffect, useRef } from 'preact/hooks';
import type { KeyPath } from '../protocol';
import { onCommand } from '../state/keys';
import { hovered, selection, sequence } from '../state/state';
import { openMenu } from '../view/menu/menu_state';
import { bindSelectionCommands, deleteSelected, duplicateSelected, templatesOf } from './commands';
import { ItemIcon } from './ItemIcon';
import { groupsNow } from './groups_now';
import { matchingGroups, type OutlineGroup, type OutlineItem } from './outline_groups';
import { isThing } from './thing';
import './outline.css';

const word = signal('');
const folded = signal<ReadonlySet<string>>(new Set(['Materials', 'Settings']));

/// Whether the selection is the item, or a part of it.
function isChosen(path: KeyPath): boolean {
    const chosen = selection.value;
    return chosen !== null && path.length > 0 && path.every((key, i) => chosen[i] === key);
}

function fold(name: string, isOpen: boolean): void {
    const next = new Set(folded.value);
    if (isOpen) {
        next.delete(name);
    } else {
        next.add(name);
    }
    folded.value = next;
}

/// The arrow keys walk through the rows: right unfolds, left folds or goes to the group; Enter and
/// the space bar choose; letters go to the next row that begins with them.
function onKey(event: KeyboardEvent): void {
    const tree = event.currentTarget as HTMLElement;
    const rows = [...tree.querySelectorAll<HTMLElement>('[data-row]')];
    const row = (event.target as HTMLElement).closest<HTMLElement>('[data-row]');
    if (!row || event.ctrlKey || event.metaKey || event.altKey) {
        return;
    }
    const at = rows.indexOf(row);
    const group = row.dataset['group'];
    const go = (to: number) => rows[Math.max(0, Math.min(rows.length - 1, to))]?.focus();
    switch (event.key) {
        case 'ArrowDown': go(at + 1); break;
        case 'ArrowUp': go(at - 1); break;
        case 'Home': go(0); break;
        case 'End': go(rows.length - 1); break;
        case 'ArrowRight':
            if (group !== undefined && folded.peek().has(group)) {
                fold(group, true);
            } else {
                go(at + 1);
            }
            break;
        case 'ArrowLeft':
            if (group !== undefined) {
                fold(group, false);
            } else {
                rows.slice(0, at).findLast((one) => one.dataset['group'] !== undefined)?.focus();
            }
            break;
        case 'Enter': case ' ': row.click(); break;
        default: return;
    }
    event.preventDefault();
    event.stopPropagation();
}

function Item({ item, isReached }: { item: OutlineItem; isReached: boolean }) {
    const isSelected = isChosen(item.path);
    const row = useRef<HTMLDivElement>(null);
    useEffect(() => {
        if (isSelected) {
            row.current?.scrollIntoView({ block: 'nearest' });
        }
    }, [isSelected]);
    return (
        <div role="treeitem" class="item" data-row ref={row} aria-selected={isSelected} aria-level={2}
            tabIndex={isReached ? 0 : -1}
            onClick={() => { selection.value = item.path; }}
            onFocus={() => { hovered.value = item.path; }}
            onBlur={() => { hovered.value = null; }}
            onPointerEnter={() => { hovered.value = item.path; }}
            onPointerLeave={() => { hovered.value = null; }}>
            <ItemIcon item={item} />
            <span class="name">{item.name}</span>
            <span class="about">{item.about}</span>
        </div>
    );
}

function Group({ group, reached }: { group: OutlineGroup; reached: string }) {
    const isOpen = !folded.value.has(group.name) || word.value !== '';
    return (
        <div role="presentation">
            <div role="treeitem" class="group" data-row data-group={group.name} aria-level={1}
                aria-expanded={isOpen} aria-selected={false}
                tabIndex={reached === group.name ? 0 : -1} onClick={() => fold(group.name, !isOpen)}>
                <ChevronRight size={13} strokeWidth={2} aria-hidden="true" />
                <span class="name">{group.name}</span>
                <span class="count">{group.section ? group.items.length : ''}</span>
            </div>
            {isOpen ? <div role="group">
                {group.items.map((item) => <Item key={item.path.join('/')} item={item}
                    isReached={reached === item.path.join('/')} />)}
            </div> : null}
        </div>
    );
}

function addMenuOfAll(button: HTMLElement): void {
    const box = button.getBoundingClientRect();
    const groups = groupsNow.peek();
    openMenu({ title: 'Add', x: box.left, y: box.bottom + 4,
        items: () => groups.filter((group) => group.section !== '').flatMap((group) =>
            templatesOf(group.section).map(({ label, run }, i) =>
                ({ label, run, hint: i === 0 ? group.name : '', startsGroup: i === 0 }))) });
}

function Head() {
    const search = useRef<HTMLInputElement>(null);
    useEffect(() => onCommand('search', () => search.current?.focus()), []);
    const hasThing = isThing(selection.value);
    return (
        <div class="head">
            <label class="seek">
                <Search size={13} aria-hidden="true" />
                <input type="search" ref={search} placeholder="Search" aria-label="Search the outline"
                    value={word.value} onInput={(event) => { word.value = event.currentTarget.value; }} />
            </label>
            <button type="button" title={sequence.value ? 'Add a part' : 'Add a ball, an event, a camera …'} aria-label="Add"
                aria-haspopup="menu" onClick={(event) => addMenuOfAll(event.currentTarget)}>
                <Plus size={15} strokeWidth={1.75} aria-hidden="true" />
            </button>
            <button type="button" title="Duplicate (Ctrl+D)" aria-label="Duplicate" disabled={!hasThing}
                onClick={duplicateSelected}>
                <Copy size={14} strokeWidth={1.75} aria-hidden="true" />
            </button>
            <button type="button" title="Delete (Del)" aria-label="Delete" disabled={!hasThing}
                onClick={deleteSelected}>
                <Trash2 size={14} strokeWidth={1.75} aria-hidden="true" />
            </button>
        </div>
    );
}

/// The list of everything in the shot. Fills its parent.
export function Outline() {
    useEffect(bindSelectionCommands, []);
    const groups = matchingGroups(groupsNow.value, word.value);
    const isOpen = (group: OutlineGroup) => !folded.value.has(group.name) || word.value !== '';
    const chosen = groups.filter(isOpen).flatMap((group) => group.items)
        .find((item) => isChosen(item.path));
    const reached = chosen?.path.join('/') ?? groups[0]?.name ?? '';
    return (
        <div class="outline">
            <Head />
            <div class="tree" role="tree" aria-label={sequence.value ? 'The film' : 'The shot'} onKeyDown={onKey}>
                {groups.map((group) => <Group key={group.name} group={group} reached={reached} />)}
            </div>
            {groups.length === 0 && word.value !== '' ? <p class="none">No matches.</p> : null}
        </div>
    );
}
