// serve.mjs FOLDER [PORT] - serves a folder to this machine only; used by `make serve`.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import zlib from 'node:zlib';

const TYPES = {
    '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.json': 'application/json',
    '.png': 'image/png', '.webp': 'image/webp', '.svg': 'image/svg+xml', '.woff2': 'font/woff2', '.txt': 'text/plain; charset=utf-8',
    '.mp4': 'video/mp4', '.zip': 'application/zip',
};

const PACKED = /\.(png|webp|mp4|woff2|zip)$/; // files that are already compressed

// The path in an address; '' if the path is not valid text, as in %FF.
function nameIn(address) {
    try {
        return decodeURIComponent(new URL(address, 'http://localhost').pathname);
    } catch {
        return '';
    }
}

// A server for the files of a folder, which is not listening yet.
//   more  additional pages that are not in the folder: path -> HTML
export function folderServer(folder, more = {}) {
    return http.createServer((request, answer) => {
        const name = path.normalize(nameIn(request.url));
        const file = path.join(folder, name.endsWith('/') ? `${name}index.html` : name);
        const head = (extension, more = {}) => answer.writeHead(200, {'content-type': TYPES[extension] ?? 'text/plain; charset=utf-8', 'cache-control': 'no-cache', ...more});
        if (more[name] !== undefined) {
            head('.html').end(more[name]);
        } else if (fs.existsSync(file) && fs.statSync(file).isFile()) {
            const packs = !PACKED.test(file) && /\bgzip\b/.test(request.headers['accept-encoding']), data = fs.createReadStream(file);
            head(path.extname(file), packs ? {'content-encoding': 'gzip', vary: 'accept-encoding'} : {});
            (packs ? data.pipe(zlib.createGzip()) : data).pipe(answer);
        } else {
            const page = path.join(folder, '404.html');
            if (fs.existsSync(page)) answer.writeHead(404, {'content-type': TYPES['.html']}).end(fs.readFileSync(page));
            else answer.writeHead(404, {'content-type': 'text/plain'}).end(`${name}: not found\n`);
        }
    });
}

if (fs.realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
    const [folder, port = '8000'] = process.argv.slice(2), server = folderServer(folder);
    server.on('error', (error) => {
        console.error(`make serve: port ${port}: ${error.code === 'EADDRINUSE' ? 'already in use; try make serve PORT=8001' : error.message}`);
        process.exitCode = 1;
    });
    server.listen(Number(port), '127.0.0.1', () => console.log(`http://127.0.0.1:${server.address().port}/ (press Ctrl+C to stop)`));
}
