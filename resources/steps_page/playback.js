// Where parts are at a time, as the program has it (core/assembly/playback.h): time is counted in
// steps, step i goes on from i to i + 1, and its parts wait a little before and after they move.
'use strict';

const WAIT = 0.12;

function ease(u) {
    return u < 0.5 ? 4 * u * u * u : 1 - 4 * (1 - u) * (1 - u) * (1 - u);
}

/// On a way of corners [x, y, z], after that share of its length.
function onWay(way, share) {
    const lengths = way.slice(1).map((corner, i) => Math.hypot(...corner.map((v, k) => v - way[i][k])));
    let left = share * lengths.reduce((sum, length) => sum + length, 0);
    for (let i = 0; i < lengths.length; ++i) {
        if (left < lengths[i])
            return way[i].map((v, k) => v + left / lengths[i] * (way[i + 1][k] - v));
        left -= lengths[i];
    }
    return way[way.length - 1];
}

class Playback {
    constructor(steps, partCount) {
        this.steps = steps;
        this.first = new Array(partCount).fill(Infinity);
        steps.forEach((step, i) => {
            for (const part of step.parts)
                this.first[part] = Math.min(this.first[part], i);
        });
    }

    /// Which step is under way or has just ended; at 0 the first one is about to begin.
    stepAt(time) {
        return Math.min(Math.max(Math.ceil(time) - 1, 0), this.steps.length - 1);
    }

    isFinished(time) {
        return time >= this.steps.length;
    }

    /// [{isThere, isMoving, offset, later}] for each part: how far it is from where it ends up, and
    /// how far it still is when this step is done. When all is finished nothing moves any more.
    at(time) {
        const now = this.stepAt(time);
        const share = ease(Math.min(Math.max((time - now - WAIT) / (1 - 2 * WAIT), 0), 1));
        const places = this.first.map(step => ({isThere: step <= now, isMoving: false, offset: [0, 0, 0], later: [0, 0, 0]}));
        // What is to be brought on later as one is still where that way begins.
        for (let i = now; i < this.steps.length; ++i) {
            const {parts, way} = this.steps[i];
            const offset = i === now ? onWay(way, share) : way[0];
            for (const part of parts) {
                if (!places[part].isThere)
                    continue;
                places[part].offset = places[part].offset.map((v, k) => v + offset[k]);
                if (i > now)
                    places[part].later = places[part].later.map((v, k) => v + offset[k]);
                else
                    places[part].isMoving = !this.isFinished(time);
            }
        }
        return places;
    }
}
