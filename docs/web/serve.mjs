// serve.mjs FOLDER [PORT] - shows a folder on this machine alone, as `make serve` does.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';

const TYPES = {
    '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.json': 'application/json',
    '.png': 'image/png', '.webp': 'image/webp', '.svg': 'image/svg+xml', '.woff2': 'font/woff2', '.txt': 'text/plain; charset=utf-8',
};
const [folder, port = '8000'] = process.argv.slice(2);

const server = http.createServer((request, answer) => {
    const name = path.normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
    const file = path.join(folder, name.endsWith('/') ? `${name}index.html` : name);
    if (fs.existsSync(file) && fs.statSync(file).isFile()) {
        answer.writeHead(200, {'content-type': TYPES[path.extname(file)] ?? 'text/plain; charset=utf-8', 'cache-control': 'no-cache'});
        fs.createReadStream(file).pipe(answer);
    } else {
        answer.writeHead(404, {'content-type': 'text/plain'});
        answer.end(`${name} is not here\n`);
    }
});
server.on('error', (error) => {
    console.error(`make serve: port ${port}: ${error.code === 'EADDRINUSE' ? 'something else listens there: make serve PORT=8001' : error.message}`);
    process.exitCode = 1;
});
server.listen(Number(port), '127.0.0.1', () => console.log(`http://127.0.0.1:${server.address().port}/ - Ctrl+C ends it`));
