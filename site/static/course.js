"use strict";

// Code is hidden or shown on all pages at once; that of drawings is folded until somebody opens it.
const button = document.getElementById("hide"), cells = [...document.querySelectorAll("details.code")];
function hide(hidden) {
  document.documentElement.classList.toggle("without-code", hidden);
  cells.forEach(cell => { cell.open = !hidden && !cell.classList.contains("drawing"); });
  button.textContent = hidden ? "Show code" : "Hide code";
}
if (cells.length) {
  button.hidden = false;
  button.onclick = () => {
    const hidden = !document.documentElement.classList.contains("without-code");
    localStorage.setItem("code", hidden ? "hidden" : "shown");
    hide(hidden);
  };
  if (localStorage.getItem("code") === "hidden") hide(true);
}

// On paper a stage is a picture in the colours of paper, and a formula is no wider than the page.
const PAPER = 660;  // pixels between its margins
let theme = null;
addEventListener("beforeprint", () => {
  if (theme === null) theme = document.body.dataset.theme;
  document.body.dataset.theme = "light";
  for (const frame of document.querySelectorAll("iframe[srcdoc]")) {
    frame.contentWindow.dress();
    frame.parentNode.querySelector(".still")?.remove();
    const still = document.createElement("div"), seen = frame.contentDocument;
    still.className = "still";
    for (const canvas of seen.querySelectorAll("canvas")) {
      const picture = still.appendChild(new Image());
      Object.assign(picture, {src: canvas.toDataURL(), alt: frame.title, width: canvas.clientWidth});
    }
    still.append(...[...seen.querySelectorAll("#words > div")].map(line => {
      const words = document.createElement("p");
      Object.assign(words, {textContent: line.textContent, className: line.className});
      return words;
    }));
    frame.after(still);
  }
  for (const formula of document.querySelectorAll("div.math mjx-container")) {
    const wide = formula.querySelector("svg")?.getBoundingClientRect().width;
    formula.style.fontSize = wide > PAPER ? `${Math.floor(100 * PAPER / wide)}%` : "";
  }
});
addEventListener("afterprint", () => {
  document.body.dataset.theme = theme;
  theme = null;
  document.querySelectorAll(".still").forEach(still => still.remove());
  document.querySelectorAll("div.math mjx-container").forEach(formula => { formula.style.fontSize = ""; });
});
