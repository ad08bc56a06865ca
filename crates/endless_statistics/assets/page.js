"use strict";
(() => {
  const all = JSON.parse(document.getElementById("charts").textContent);
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  // After Okabe and Ito, told apart by all eyes; a class has the same colour in every chart.
  const light_colors = ["#0072b2", "#63b3e6", "#6b7280", "#009e73", "#cc79a7", "#d4a000", "#7a5195", "#d55e00"];
  const dark_colors = ["#3d94d1", "#9ad0f5", "#9aa5b1", "#3cc79b", "#e3a3c8", "#e5c04b", "#b79ad6", "#f08a4b"];
  const of_name = { car: 0, van: 1, truck: 2, bus: 3, motorcycle: 4, bicycle: 5, rider: 6, pedestrian: 7,
    morning: 5, afternoon: 1, night: 6 };
  const style = (is_dark) => is_dark
    ? { colors: dark_colors, text: "#c3cbd4", grid: "#343b44" }
    : { colors: light_colors, text: "#3c4650", grid: "#e2e6ea" };
  const number = new Intl.NumberFormat("en-US");
  const short = new Intl.NumberFormat("en-US", { notation: "compact", maximumFractionDigits: 1 });
  const color = (colors, series, place) => colors[(Object.hasOwn(of_name, series.name) ? of_name[series.name] : [0, 7, 3, 5][place % 4]) % colors.length];
  const narrow = () => window.innerWidth < 520;

  function config(chart, look) {
    const total = chart.series.reduce((sum, series) => sum + series.values.reduce((a, b) => a + b, 0), 0);
    const value = { beginAtZero: true, stacked: chart.stacked, grid: { color: look.grid }, border: { display: false },
      title: { display: true, text: chart.value_axis, color: look.text },
      ticks: { color: look.text, maxTicksLimit: chart.lying && narrow() ? 4 : 7, precision: chart.percent ? undefined : 0,
        callback: (v) => chart.percent ? v + "%" : short.format(v) } };
    const label = { stacked: chart.stacked, grid: { display: false }, border: { color: look.grid },
      title: { display: true, text: chart.label_axis, color: look.text },
      ticks: { color: look.text, autoSkip: !chart.lying, autoSkipPadding: 10, maxRotation: chart.ordered || chart.lying ? 0 : 50,
        callback(v) { const text = this.getLabelForValue(v); const most = narrow() ? 18 : 32;
          return text.length > most ? text.slice(0, most - 1) + "\u2026" : text; } } };
    return {
      type: "bar",
      data: { labels: chart.labels, datasets: chart.series.map((series, place) => ({
        label: series.name, data: series.values, backgroundColor: color(look.colors, series, place),
        borderRadius: chart.series.length > 1 ? 0 : 2, maxBarThickness: 34,
        categoryPercentage: chart.stacked ? 0.9 : 0.8, barPercentage: chart.stacked ? 0.95 : 1 })) },
      options: {
        animation: false, responsive: true, maintainAspectRatio: false, indexAxis: chart.lying ? "y" : "x",
        interaction: { mode: "index", axis: chart.lying ? "y" : "x", intersect: false },
        scales: chart.lying ? { x: value, y: label } : { x: label, y: value },
        plugins: {
          legend: { display: chart.series.length > 1, position: "bottom",
            labels: { color: look.text, boxWidth: 11, boxHeight: 11, padding: 10 } },
          tooltip: { filter: (item) => item.raw > 0, callbacks: { label: (item) => chart.percent
            ? ` ${item.dataset.label}: ${item.raw.toFixed(1)}%`
            : ` ${item.dataset.label}: ${number.format(item.raw)} (${(100 * item.raw / Math.max(total, 1)).toFixed(1)}%)` } },
        },
      },
    };
  }

  let drawn = [];
  function draw(is_dark) {
    drawn.forEach((chart) => chart.destroy());
    const look = style(is_dark);
    drawn = [...document.querySelectorAll("canvas[data-chart]")].map((canvas) =>
      new Chart(canvas, config(all[Number(canvas.dataset.chart)], look)));
  }
  draw(dark.matches);
  dark.addEventListener("change", () => draw(dark.matches));
  window.addEventListener("beforeprint", () => { draw(false); drawn.forEach((chart) => chart.resize()); });
  window.addEventListener("afterprint", () => draw(dark.matches));
})();
