/// Plays a film, also frame by frame.
import { withKey } from '../connection/key';
import { useSignal } from '@preact/signals';
import { ChevronFirst, ChevronLast, ChevronLeft, ChevronRight, Pause, Play } from 'lucide-preact';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';

interface Properties {
    address: string;
    fps: number;
    width: number;
    height: number;
    children?: ComponentChildren;  // at the right of the buttons
}

/// The frame that is shown at a time of the video, and a time at which a frame is shown for sure.
export function frameAt(time: number, fps: number): number {
    return Math.max(0, Math.floor(time * fps + 1e-3));
}

export function timeOf(frame: number, fps: number): number {
    return (frame + 0.5) / fps;
}

interface StepProperties {
    label: string;
    icon: typeof Play;
    run(): void;
}

function Step({ label, icon: Icon, run }: StepProperties) {
    return (
        <button type="button" class="tool" aria-label={label} title={label} onClick={run}>
            <Icon size={17} strokeWidth={1.75} aria-hidden="true" />
        </button>
    );
}

export function FilmPlayer({ address, fps, width, height, children }: Properties) {
    const element = useRef<HTMLVideoElement>(null);
    const frame = useSignal(0);
    const frames = useSignal(0);
    const isPlaying = useSignal(false);
    const sought = useRef<number | null>(null); // the frame whose picture has not come yet
    const isBroken = useSignal(false);
    const goTo = (wanted: number) => {
        const video = element.current;
        if (video) {
            video.pause();
            const last = Math.max(0, frames.peek() - 1);
            const next = Math.min(Math.max(wanted, 0), last);
            video.currentTime = timeOf(next, fps);
            frame.value = next;
            sought.current = next;
        }
    };
    const toggle = () => {
        const video = element.current;
        void (video?.paused ? video.play() : video?.pause());
    };
    useEffect(() => {
        isBroken.value = false;
        sought.current = null;
        const video = element.current;
        if (!video) {
            return undefined;
        }
        let id = 0;
        const show: VideoFrameRequestCallback = (_, { mediaTime }) => {
            // A picture from before a seek may arrive after it, on a busy machine also when it has ended.
            const shown = frameAt(mediaTime, fps);
            if (sought.current === null || sought.current === shown) {
                sought.current = null;
                frame.value = shown;
            }
            id = video.requestVideoFrameCallback(show);
        };
        id = video.requestVideoFrameCallback(show);
        return () => video.cancelVideoFrameCallback(id);
    }, [address]);
    const onKey = (event: KeyboardEvent) => {
        const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
        if (step) {
            event.preventDefault();
            goTo(frame.peek() + step * (event.shiftKey ? 10 : 1));
        } else if (event.key === ' ' && event.target === element.current) {
            event.preventDefault();
            toggle();
        }
    };
    if (isBroken.value) {
        return (
            <div class="player">
                <p class="broken">
                    This browser cannot play the film: not every browser knows HEVC, ProRes and other
                    formats. Download it to watch it in another player.
                </p>
                {children}
            </div>
        );
    }
    return (
        <div class="player" onKeyDown={onKey}>
            <video ref={element} src={withKey(address)} width={width} height={height} loop tabIndex={0}
                aria-label="The film" preload="auto" onClick={toggle}
                onError={() => { isBroken.value = true; }}
                onPlay={() => {
                    isPlaying.value = true;
                    sought.current = null;
                }}
                onPause={() => { isPlaying.value = false; }}
                onLoadedMetadata={(event) => {
                    frames.value = Math.round(event.currentTarget.duration * fps);
                }} />
            <input type="range" aria-label="Frame" min={0} max={Math.max(0, frames.value - 1)}
                value={frame.value} aria-valuetext={`frame ${frame.value}`}
                onInput={(event) => goTo(event.currentTarget.valueAsNumber)} />
            <div class="steps">
                <Step label="First frame" icon={ChevronFirst} run={() => goTo(0)} />
                <Step label="One frame back" icon={ChevronLeft} run={() => goTo(frame.peek() - 1)} />
                <Step label={isPlaying.value ? 'Pause' : 'Play'} icon={isPlaying.value ? Pause : Play}
                    run={toggle} />
                <Step label="One frame forward" icon={ChevronRight} run={() => goTo(frame.peek() + 1)} />
                <Step label="Last frame" icon={ChevronLast} run={() => goTo(frames.peek() - 1)} />
                <span class="number">frame {frame.value} of {frames.value}, {timeText(frame.value / fps)}</span>
                {children}
            </div>
        </div>
    );
}

function timeText(seconds: number): string {
    return `${seconds.toFixed(2)} s`;
}
