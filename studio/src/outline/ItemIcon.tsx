/// The symbol of a thing of the shot.
import {
    Box, Circle, CircleDashed, CircleDot, Cone, Crosshair, Cylinder, DraftingCompass, Globe, Heading, Image,
    Lamp, LampCeiling, Map, MoveRight, Palette, RotateCw, Settings2, Shapes, Slash, Spline,
    SquareDashed, Sun, Tag, Target, Type, Video, Wind, type LucideIcon,
} from 'lucide-preact';
import { shot } from '../state/state';
import { cssOfLinear } from '../strip/colours';
import type { OutlineItem } from './outline_groups';

const kIcons: Record<string, LucideIcon> = {
    camera: Video, material: Palette, setting: Settings2, strike: Target, impulse: MoveRight,
    force: Wind, velocity: MoveRight, torque: CircleDot, box: Box, sphere: Circle,
    cylinder: Cylinder, cone: Cone, rectangle: LampCeiling, point: Lamp, spot: Lamp, sun: Sun,
    environment: Globe, path: Spline, aim: Crosshair, ghost: CircleDashed, tangent: Slash, spin: RotateCw,
    angle: DraftingCompass, zone: SquareDashed, label: Tag, text: Type, title: Heading, tip: Target,
    plan: Map, image: Image,
};

/// A ball is shown in its colour, all else by a line drawing.
export function ItemIcon({ item }: { item: OutlineItem }) {
    if (item.kind === 'ball') {
        const ball = shot.value?.objects.find((one) => one.name === item.name && one.kind === 'ball');
        return (
            <span class="ball" aria-hidden="true"
                style={ball ? { background: cssOfLinear(ball.colour) } : undefined} />
        );
    }
    const Icon = kIcons[item.kind] ?? Shapes;
    return <Icon size={14} strokeWidth={1.75} aria-hidden="true" class={item.kind} />;
}
