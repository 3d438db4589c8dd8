/// The tools for what is selected in the view: a group of the view's toolbar.
import { Move3d, Pin, Rotate3d, Scale3d, Split, type LucideIcon } from 'lucide-preact';
import { runCommand, type Command } from '../../state/keys';
import { isFanShown } from './fan_state';
import { pinned } from './pinned';
import { tool, type Tool } from './tool_state';

const kTools: readonly { name: Tool; icon: LucideIcon; label: string; command: Command }[] = [
    { name: 'move', icon: Move3d, label: 'Move what is selected (M)', command: 'toolMove' },
    { name: 'turn', icon: Rotate3d, label: 'Turn what is selected (E)', command: 'toolTurn' },
    {
        name: 'scale', icon: Scale3d, label: 'Measures of what is selected (S)',
        command: 'toolScale',
    },
];

interface Properties {
    icon: LucideIcon;
    label: string;
    isPressed: boolean;
    onClick(): void;
}

function Button({ icon: Icon, label, isPressed, onClick }: Properties) {
    return (
        <button type="button" class="tool" title={label} aria-label={label} aria-pressed={isPressed}
            onClick={onClick}>
            <Icon size={16} strokeWidth={1.75} aria-hidden="true" />
        </button>
    );
}

export function ToolButtons() {
    return (
        <div class="group">
            {kTools.map(({ name, icon, label, command }) => (
                <Button key={name} icon={icon} label={label} isPressed={tool.value === name}
                    onClick={() => runCommand(command)} />
            ))}
            <Button icon={Pin} label="Pin the present paths (P)"
                isPressed={pinned.value !== null} onClick={() => runCommand('pinGhost')} />
            <Button icon={Split} label="Eight slightly different strikes (V)"
                isPressed={isFanShown.value} onClick={() => runCommand('fan')} />
        </div>
    );
}
