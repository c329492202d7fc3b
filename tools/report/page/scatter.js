// Scatter plots of a study: a response over a factor, a point a run.

/** Room around points. */
function widened(plot, low, high) {
    const room = 0.06 * (high - low) || 0.5;
    return [low - room, high + room];
}

/** The mean of equal x's, at the last of them, null at the others: [x, y] sorted by x. */
function means(points) {
    return points.map(([x], k) => {
        if (k + 1 < points.length && points[k + 1][0] === x) return null;
        const same = points.filter((p) => p[0] === x);
        return same.reduce((sum, p) => sum + p[1], 0) / same.length;
    });
}

/** Which point the mouse means: of those at x of point k, the one nearest to y. */
function nearest(points, k, y) {
    const off = (one) => Math.abs(points[one][1] - y);
    return points.reduce((best, p, one) => p[0] === points[k][0] && off(one) < off(best) ? one : best, k);
}

/** @param points  [factor, response, name of the run] */
function scatter(place, points, factor, response) {
    points.sort((a, b) => a[0] - b[0]);
    const [blue, orange] = LINE_COLOURS, columns = [points.map((p) => p[0]), points.map((p) => p[1])];
    if (new Set(columns[0]).size < points.length) columns.push(means(points));  // there are several runs at a value
    const options = {
        title: `${response} over ${factor}`,
        width: place.clientWidth,
        height: CHART_HEIGHT,
        scales: {x: {time: false, range: widened}, y: {range: widened}},
        axes: [axis(factor, ALONG), axis(null, UP)],
        series: [
            {label: factor, value: (plot, x) => x === null ? "-" : show(x)},
            {label: "run", stroke: blue, paths: () => null, points: {show: true, size: 7, fill: blue}, value: (plot, y, s, k) => k === null ? "-" : `${points[k][2]}: ${show(y)}`},
            {label: "mean", stroke: orange, width: 1.8, spanGaps: true, points: {show: false}, value: (plot, y) => y === null ? "-" : show(y)},
        ].slice(0, columns.length),
        cursor: {drag: {dist: 5}, dataIdx: (plot, s, k) => s === 1 ? nearest(points, k, plot.posToVal(plot.cursor.top, "y")) : points.findLastIndex((p) => p[0] === points[k][0])},
    };
    return new lib.uPlot(options, columns, place);
}
