/// The tools of the view, over its upper left corner.
import {
    Box, Eye, Frame, Grid3x3, LockKeyhole, LockKeyholeOpen, PanelBottom, Square, Video,
    type LucideIcon,
} from 'lucide-preact';
import { runCommand } from '../../state/keys';
import { kTheFilm, lookThrough, shot } from '../../state/state';
import {
    isCameraLocked, isWireframe, lampsChosen, showAnnotations, showCameras, showLamps, showLights,
    showTrails, viewKind,
} from '../../state/view_state';
import { ToolButtons } from '../gizmos/ToolButtons';
import { menu, openMenu } from '../menu/menu_state';
import './view_toolbar.css';

interface ToolProperties {
    icon: LucideIcon;
    label: string;
    onClick(event: MouseEvent & { currentTarget: HTMLButtonElement }): void;
    isPressed?: boolean;
    opensMenu?: boolean;
}

function Tool({ icon: Icon, label, onClick, isPressed, opensMenu }: ToolProperties) {
    return (
        <button type="button" class="tool" title={label} aria-label={label} aria-pressed={isPressed}
            aria-haspopup={opensMenu ? 'menu' : undefined} onClick={onClick}>
            <Icon size={16} strokeWidth={1.75} aria-hidden="true" />
        </button>
    );
}

const kOwnViews = [
    { kind: 'free', icon: Box, label: 'Free view (3)', command: 'viewFree' },
    { kind: 'top', icon: Square, label: 'View from above (1)', command: 'viewTop' },
    { kind: 'side', icon: PanelBottom, label: 'View from the side (2)', command: 'viewSide' },
] as const;

function showMenu(x: number, y: number): void {
    const parts = [
        { label: 'Cameras', shown: showCameras },
        { label: 'Lights', shown: showLights },
        { label: 'Paths of the balls', shown: showTrails },
        { label: 'Annotations in the scene', shown: showAnnotations },
    ];
    openMenu({
        title: 'Show', x, y,
        items: () => [
            ...parts.map(({ label, shown }) => ({
                label, isOn: shown.value, run: () => { shown.value = !shown.peek(); },
            })),
            {
                label: 'Lamps', isOn: showLamps.value, isDisabled: lookThrough.value !== null,
                run: () => { lampsChosen.value = !showLamps.peek(); },
            },
        ],
    });
}

function below(button: HTMLElement): [number, number] {
    const box = button.getBoundingClientRect();
    return [box.left, box.bottom + 4];
}

function CameraTools() {
    const cameras = shot.value?.cameras ?? [];
    const isThrough = lookThrough.value !== null;
    const locked = isCameraLocked.value;
    return (
        <div class="group">
            <Tool icon={Video} label="Look through the film’s camera (C)" isPressed={isThrough}
                onClick={() => runCommand('lookThrough')} />
            <select class="choice" aria-label="Look through" value={lookThrough.value ?? ''}
                onChange={(event) => { lookThrough.value = event.currentTarget.value || null; }}>
                <option value="">no camera</option>
                {cameras.length > 0 ? (
                    <option value={kTheFilm} title="The camera at the play head">the film</option>
                ) : null}
                {cameras.map(({ name }) => <option key={name} value={name}>{name}</option>)}
            </select>
            {isThrough ? (
                <Tool icon={locked ? LockKeyhole : LockKeyholeOpen} isPressed={locked}
                    label="Moving the view moves the camera"
                    onClick={() => { isCameraLocked.value = !locked; }} />
            ) : null}
        </div>
    );
}

export function ViewToolbar() {
    const isOwn = lookThrough.value === null;
    return (
        <div class="view-toolbar" role="toolbar" aria-label="View">
            <div class="group">
                {kOwnViews.map(({ kind, icon, label, command }) => (
                    <Tool key={kind} icon={icon} label={label}
                        isPressed={isOwn && viewKind.value === kind}
                        onClick={() => runCommand(command)} />
                ))}
            </div>
            <CameraTools />
            <ToolButtons />
            <div class="group">
                <Tool icon={Frame} label="Frame the selection (F)"
                    onClick={() => runCommand('frameSelection')} />
                <Tool icon={Grid3x3} label="Edges only (W)" isPressed={isWireframe.value}
                    onClick={() => runCommand('wireframe')} />
                <Tool icon={Eye} label="Show or hide" opensMenu isPressed={menu.value?.title === 'Show'}
                    onClick={(event) => showMenu(...below(event.currentTarget))} />
            </div>
        </div>
    );
}
