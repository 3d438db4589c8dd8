import {
    ChevronLeft, ChevronRight, ChevronsLeft, ChevronsRight, ListFilter, Maximize2, Pause, Play, Repeat,
    SkipBack, type LucideIcon,
} from 'lucide-preact';
import { filmCamera, goToFilmTime } from '../motion/clock';
import { runCommand, type Command } from '../state/keys';
import { SoundTools } from '../sound/SoundTools';
import { openMenu } from '../view/menu/menu_state';
import { shownPart } from '../sequence/parts';
import { filmTime, isSequence, playing, sceneTime, sequence, shot } from '../state/state';
import { filmClock, sceneClock, speedText } from './clock_text';
import { kCurves } from './curves';
import { otherInstants } from './instants';
import { currentFrame, kSpeeds, loops, speed } from './playback';
import { currentEvent, curveName, kEventGroups, shownGroups, type CurveName, type EventGroup }
    from './strip_state';

interface StepProperties {
    icon: LucideIcon;
    label: string;
    command: Command;
    isPressed?: boolean;
}

function Step({ icon: Icon, label, command, isPressed }: StepProperties) {
    return (
        <button type="button" title={label} aria-label={label} aria-pressed={isPressed}
            onClick={() => runCommand(command)}>
            <Icon size={15} strokeWidth={1.75} aria-hidden="true" />
        </button>
    );
}

/// Both clocks: the film's time and frame, the scene's time, and the camera that films it.
function Clocks() {
    const camera = shot.value?.cameras[filmCamera.value]?.name;
    const part = sequence.value?.parts[shownPart.value];
    if (isSequence.value) {
        return (
            <div class="clocks">
                <span>film <b>{filmClock(filmTime.value)}</b> frame <b>{currentFrame()}</b></span>
                {part ? <span class="part">part <b>{shownPart.value + 1}</b> {part.name}</span> : null}
            </div>
        );
    }
    return (
        <div class="clocks">
            <span>film <b>{filmClock(filmTime.value)}</b> frame <b>{currentFrame()}</b></span>
            <span>scene <b>{sceneClock(sceneTime.value)}</b></span>
            {camera ? <span class="camera">camera <b>{camera}</b></span> : null}
            {currentEvent.value ? <span class="event">{currentEvent.value.text}</span> : null}
        </div>
    );
}

/// The other instants of the film that show the same time of the scene.
function Instants() {
    const cameras = shot.value?.cameras ?? [];
    const fps = shot.value?.film.fps ?? 24;
    return otherInstants.value.length === 0 ? null : (
        <select class="instants" aria-label="Other moments of the film that show this scene time"
            title="Other moments of the film that show this scene time" value=""
            onChange={(event) => { goToFilmTime(Number(event.currentTarget.value)); }}>
            <option value="">also in {otherInstants.value.length}</option>
            {otherInstants.value.map(({ time, camera }) => (
                <option key={`${camera} ${time}`} value={time}>
                    {cameras[camera]?.name} {filmClock(time)}, frame {Math.floor(time * fps + 1e-6)}
                </option>
            ))}
        </select>
    );
}

function toggleGroup(group: EventGroup): void {
    const next = new Set(shownGroups.value);
    if (!next.delete(group)) {
        next.add(group);
    }
    shownGroups.value = next;
}

/// Which events the strip shows, and [ and ] visit.
function EventFilter() {
    const open = (button: HTMLElement) => {
        const box = button.getBoundingClientRect();
        openMenu({ title: 'Events on the strip', x: box.left, y: box.bottom + 4,
            items: () => kEventGroups.map(({ group, label, about }) => ({ label, hint: about,
                isOn: shownGroups.value.has(group), run: () => toggleGroup(group) })) });
    };
    return (
        <button type="button" title="Events on the strip" aria-label="Events on the strip"
            aria-haspopup="menu" onClick={(event) => open(event.currentTarget)}>
            <ListFilter size={15} strokeWidth={1.75} aria-hidden="true" />
            <span>Events</span>
        </button>
    );
}

function CurveChoice() {
    return (
        <select aria-label="Camera curve" value={curveName.value}
            onChange={(event) => { curveName.value = event.currentTarget.value as CurveName; }}>
            {kCurves.map(({ name, label }) => <option key={name} value={name}>{label}</option>)}
        </select>
    );
}

/// The buttons of time, the clocks, and what the strip shows.
export function Transport() {
    const stop = isSequence.value ? 'part' : 'event';
    return (
        <div class="transport" role="toolbar" aria-label="Time">
            <Step icon={SkipBack} label="To the start (Home)" command="toStart" />
            <Step icon={ChevronsLeft} label={`Previous ${stop} ([)`} command="eventBack" />
            <Step icon={ChevronLeft} label="One frame back (←)" command="frameBack" />
            <Step icon={playing.value ? Pause : Play} command="play"
                label={playing.value ? 'Pause (Space)' : 'Play (Space)'} />
            <Step icon={ChevronRight} label="One frame forward (→)" command="frameForward" />
            <Step icon={ChevronsRight} label={`Next ${stop} (])`} command="eventForward" />
            <Step icon={Repeat} label="Repeat (L)" command="loop" isPressed={loops.value} />
            <select aria-label="Playback speed" value={String(speed.value)}
                onChange={(event) => { speed.value = Number(event.currentTarget.value); }}>
                {kSpeeds.map((choice) => (
                    <option key={choice} value={String(choice)}>{speedText(choice)}</option>
                ))}
            </select>
            <SoundTools />
            <Clocks />
            <Instants />
            <div class="spring" />
            {isSequence.value ? null : <><EventFilter /><CurveChoice /></>}
            <Step icon={Maximize2} label="Show all times (Shift+F)" command="fitStrip" />
        </div>
    );
}
