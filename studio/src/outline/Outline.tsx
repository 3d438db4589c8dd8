import type { KeyPath } from '../protocol';
import { hovered, selection, shot } from '../state/state';
import { outlineGroups } from './outline_groups';
import './outline.css';

/// Whether the selection is the item, or a part of it.
function isChosen(path: KeyPath): boolean {
    const chosen = selection.value;
    return chosen !== null && path.length > 0 && path.every((key, i) => chosen[i] === key);
}

/// The arrow keys go from item to item; Enter and the space bar choose one.
function onKey(event: KeyboardEvent): void {
    const tree = event.currentTarget as HTMLElement;
    const items = [...tree.querySelectorAll<HTMLElement>('[data-item]')];
    const at = items.indexOf(document.activeElement as HTMLElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: items.length - 1 }[event.key];
    if (to !== undefined) {
        items[Math.max(0, Math.min(items.length - 1, to))]?.focus();
        event.preventDefault();
    } else if (event.key === 'Enter' || event.key === ' ') {
        items[at]?.click();
        event.preventDefault();
    }
}

/// The list of everything in the shot. Fills its parent.
export function Outline() {
    const groups = shot.value ? outlineGroups(shot.value) : [];
    const chosen = groups.flatMap((group) => group.items).find((item) => isChosen(item.path));
    const first = groups[0]?.items[0];
    return (
        <div class="outline" role="tree" aria-label="The shot" onKeyDown={onKey}>
            {groups.map((group) => (
                <div role="treeitem" aria-label={group.name} aria-expanded="true" key={group.name}
                    aria-selected="false">
                    <h2>{group.name}</h2>
                    <div role="group">
                        {group.items.map((item) => (
                            <div role="treeitem" class="item" data-item key={item.path.join('/')}
                                aria-selected={isChosen(item.path)}
                                tabIndex={item === (chosen ?? first) ? 0 : -1}
                                onClick={() => { selection.value = item.path; }}
                                onPointerEnter={() => { hovered.value = item.path; }}
                                onPointerLeave={() => { hovered.value = null; }}>
                                <span class="name">{item.name}</span>
                                <span class="about">{item.about}</span>
                            </div>
                        ))}
                    </div>
                </div>
            ))}
        </div>
    );
}
