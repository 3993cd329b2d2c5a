// What lies over the model: the numbers that are engraved on its parts, and the arrow along which
// parts come.
'use strict';

const BESIDE = 22; // px, a number from the arrow
const SHORTEST = 38; // px, of an arrow
const PLACES_LAST = 90; // ms that a number keeps its place while the model turns

class Marks {
    constructor(canvas, model) {
        this.canvas = canvas;
        this.model = model;
        this.places = [];
        this.since = -Infinity;
    }

    resize(width, height, ratio) {
        this.canvas.width = Math.round(width * ratio);
        this.canvas.height = Math.round(height * ratio);
        this.ratio = ratio;
        this.since = -Infinity;
    }

    /// Of each part: where its number is seen. Looking for that takes a while, so it is not done
    /// for every picture of a motion; `isLast` has it done.
    choose(now, isLast) {
        if (!isLast && now - this.since < PLACES_LAST)
            return;
        this.since = now;
        const way = this.wayOnScreen();
        this.places = this.model.parts.map(part => {
            if (!part.isThere)
                return null;
            if (part.isMoving)
                return this.besideWay(part, way);
            return part.places.find(place => isInside(part.shape, place.x, place.y) &&
                !this.model.isCovered(this.model.onFace(part, place), part));
        });
    }

    /// Of what moves: the first place that the arrow leaves readable, or the one farthest from it.
    besideWay(part, way) {
        if (way.length < 2)
            return part.places[0];
        const [tip, last] = [way[way.length - 1], way[way.length - 2]];
        const length = Math.hypot(tip.x - last.x, tip.y - last.y) || 1;
        let best = null, most = -1;
        for (const place of part.places) {
            const {x, y} = this.model.onScreen(this.model.onFace(part, place));
            const across = Math.abs((tip.x - last.x) * (y - tip.y) - (tip.y - last.y) * (x - tip.x)) / length;
            if (Math.min(across, BESIDE) > most + 1) {
                most = Math.min(across, BESIDE);
                best = place;
            }
        }
        return best;
    }

    /// The corners of the way of what moves, where its middle goes; none for what is put down.
    wayOnScreen() {
        const {playback, time, parts} = this.model;
        const {way, parts: moving} = playback.steps[playback.stepAt(time)];
        if (way.length < 2 || playback.isFinished(time))
            return [];
        const middle = new THREE.Vector3();
        for (const i of moving)
            middle.addScaledVector(parts[i].end, 1 / moving.length);
        return way.map(corner => this.model.onScreen(middle.clone().add(new THREE.Vector3(...corner))));
    }

    draw(now, isLast) {
        this.choose(now, isLast);
        const pen = this.canvas.getContext('2d');
        pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
        pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
        pen.lineJoin = pen.lineCap = 'round';
        pen.textAlign = 'center';
        pen.textBaseline = 'middle';
        this.drawWay(pen);
        const taken = [];
        const order = this.model.parts.map((part, i) => i)
            .sort((a, b) => this.model.parts[b].isMoving - this.model.parts[a].isMoving || a - b);
        for (const i of order)
            this.drawNumber(pen, this.model.parts[i], this.places[i], taken);
    }

    /// Where there is room: numbers that lie over each other cannot be read.
    drawNumber(pen, part, place, taken) {
        if (!place || !part.isThere)
            return;
        const {x, y} = this.model.onScreen(this.model.onFace(part, place));
        const size = part.isMoving ? 17 : 13, half = size * (0.3 * String(part.number).length + 0.2);
        if (taken.some(t => Math.abs(t.x - x) < t.half + half && Math.abs(t.y - y) < (t.size + size) / 2))
            return;
        taken.push({x, y, half, size});
        pen.font = `700 ${size}px system-ui, sans-serif`;
        pen.lineWidth = 4;
        pen.strokeStyle = part.isMoving ? colourOf('--panel') : 'rgba(255, 255, 255, 0.85)';
        pen.fillStyle = part.isMoving ? colourOf('--accent') : '#1b2127';
        pen.strokeText(part.number, x, y);
        pen.fillText(part.number, x, y);
    }

    drawWay(pen) {
        const corners = this.wayOnScreen();
        if (corners.length < 2)
            return;
        const tip = corners[corners.length - 1], last = corners[corners.length - 2];
        const length = Math.hypot(tip.x - last.x, tip.y - last.y);
        if (length < 2)
            return; // towards the eye
        const ux = (tip.x - last.x) / length, uy = (tip.y - last.y) / length;
        if (corners.length === 2 && length < SHORTEST) // a short way has its direction, too
            corners[0] = {x: tip.x - SHORTEST * ux, y: tip.y - SHORTEST * uy};
        const lines = new Path2D(), head = new Path2D();
        corners.forEach((corner, i) => {
            const end = i === corners.length - 1 ? {x: tip.x - 8 * ux, y: tip.y - 8 * uy} : corner;
            lines.lineTo(end.x, end.y);
        });
        head.moveTo(tip.x, tip.y);
        head.lineTo(tip.x - 13 * ux + 6 * uy, tip.y - 13 * uy - 6 * ux);
        head.lineTo(tip.x - 13 * ux - 6 * uy, tip.y - 13 * uy + 6 * ux);
        head.closePath();
        for (const [colour, wider] of [[colourOf('--panel'), 3], [colourOf('--accent'), 0]]) {
            pen.strokeStyle = pen.fillStyle = colour;
            pen.lineWidth = 2.5 + wider;
            pen.stroke(lines);
            pen.lineWidth = wider || 1;
            pen.stroke(head);
            pen.fill(head);
        }
    }
}
