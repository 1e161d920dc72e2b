// play.js
